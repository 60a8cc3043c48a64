package org.evoloop.converter;

import java.time.Duration;
import java.time.Instant;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.jspecify.annotations.Nullable;

/**
 * One event and its outcome.
 *
 * <p>Threading: immutable.
 *
 * @param number counts the events of a converter, from 1
 * @param at when it ended
 * @param occurrence the event
 * @param before the states before it
 * @param after the states after it
 * @param outcome its outcome
 * @param detail the events sent, the function started, or why nothing happened; and the progress of a function that it
 *     ended, if reported
 * @param decision its decision: the transition of the new model and the steps planned for the device; null if it was
 *     not decided, or its plan broke off
 * @param took the time from its observation to its end
 * @since 0.1
 */
public record HistoryEntry(
        long number,
        Instant at,
        Occurrence occurrence,
        Configuration before,
        Configuration after,
        Outcome outcome,
        String detail,
        @Nullable Decision decision,
        Duration took) {
    /** When the event was observed: a control was operated, for example. */
    public Instant observedAt() {
        return at.minus(took);
    }
}
