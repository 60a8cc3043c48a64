package org.evoloop.converter;

import java.time.Instant;
import org.evoloop.core.Outcome;
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
 * @param detail the events sent, the function started, or why nothing happened; and how far a function was that it
 *     ended, if that said so
 * @since 0.1
 */
public record HistoryEntry(
        long number,
        Instant at,
        Occurrence occurrence,
        Configuration before,
        Configuration after,
        Outcome outcome,
        String detail) {}
