package org.evoloop.converter;

import java.time.Instant;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;

/**
 * One event and what became of it.
 *
 * <p>Threading: immutable.
 *
 * @param number counts the events of a converter, from 1
 * @param at when it came to its end
 * @param occurrence the event
 * @param before where the system stood
 * @param after where it stands
 * @param outcome what became of the event
 * @param detail the events sent, the function started, or why nothing happened
 */
public record HistoryEntry(
        long number,
        Instant at,
        Occurrence occurrence,
        Configuration before,
        Configuration after,
        Outcome outcome,
        String detail) {

    /** What can become of an event. */
    public enum Outcome {
        /** It had its effect. */
        HANDLED,
        /** The new model has no transition for it. */
        IGNORED,
        /** It was raised in an earlier visit of a state and came too late. */
        STALE,
        /** It could not be carried out, or not to its end. */
        FAILED,
        /** The queue was full. */
        DROPPED
    }
}
