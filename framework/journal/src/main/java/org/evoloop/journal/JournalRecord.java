package org.evoloop.journal;

import java.time.Instant;
import java.util.List;
import org.evoloop.engine.Input;
import org.evoloop.evolution.Configuration;

/**
 * A record of a journal.
 *
 * <p>Threading: immutable.
 *
 * @param segment the name of its file
 * @param number its number in its segment, from 1; 0 for a takeover by other models, which begins the segment
 * @param offset where its payload begins in the file, in bytes
 * @param at the time of day, computed from the segment's beginning, of the latest input time up to this record
 * @param nanos the same time on the converter's monotonic clock
 * @param kind the kind of input: {@code observed}, {@code planned}, {@code sending}, and so on
 * @param input the input
 * @param where the states of both models after it
 * @param doubt why that may be wrong; empty if it is certain
 * @param endings the events that ended with it, and how
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
