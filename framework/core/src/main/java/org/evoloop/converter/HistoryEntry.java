package org.evoloop.converter;

import java.time.Duration;
import java.time.Instant;
import org.evoloop.core.Outcome;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.jspecify.annotations.Nullable;

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
 * @param decision what it was found to mean: the transition of the new model and the steps planned for the device; null if it
 *     did not come so far
 * @param took from when it was observed to its end
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
        Duration took) {}
