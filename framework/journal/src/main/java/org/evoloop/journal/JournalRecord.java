package org.evoloop.journal;

import java.time.Instant;
import java.util.List;
import org.evoloop.core.Input;
import org.evoloop.evolution.Configuration;

/**
 * A record of a journal.
 *
 * <p>Threading: immutable.
 *
 * @param segment the name of its file
 * @param number of the record in its segment, from 1; 0 where other models took over with the segment
 * @param offset where its payload begins in the file, in bytes
 * @param at the time of day, by the clock that the segment began with; that of the latest time that was told by then
 * @param nanos the same on the converter's monotonic clock
 * @param kind what the converter was told: {@code observed}, {@code planned}, {@code sending}, and so on
 * @param input the same in full
 * @param where the states of both models once it was told
 * @param doubt why that may be wrong; empty if it is certain
 * @param endings the events that came to their end, and how
 * @since 0.1
 */
public record JournalRecord(
        String segment,
        long number,
        int offset,
        Instant at,
        long nanos,
        String kind,
        Input input,
        Configuration where,
        String doubt,
        List<String> endings) {}
