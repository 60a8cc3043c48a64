package org.evoloop.converter;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.evoloop.core.Outcome;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * The last events and what became of them, {@value #SIZE} unless more are wanted.
 *
 * <p>Threading: guarded by the lock of the {@link CoreDriver}.
 */
final class History {
    private static final int SIZE = 200;

    private final Clock clock;
    private final HistoryLine[] lines;
    private final int size;
    private long recorded;

    /** How many were recorded by others before the first. */
    private long before;

    /** Where the event that is about to end has left a function. */
    private volatile String leaving = "";

    History(Clock clock) {
        this(clock, SIZE);
    }

    /** @param size how many are kept */
    History(Clock clock, int size) {
        this.clock = clock;
        this.size = size;
        this.lines = new HistoryLine[size];
    }

    /** The last one that was recorded is so many-th of all that there have ever been. */
    void countOn(long number) {
        before = Math.max(0, number - recorded);
    }

    /**
     * Records an event that has come to its end.
     *
     * @param decision what it was found to mean, which gives the detail; null if {@code detail} does
     */
    void record(
            Occurrence occurrence,
            Configuration before,
            Configuration after,
            Outcome outcome,
            @Nullable Decision decision,
            String detail) {
        // A stay that ended otherwise, as by a stop, is none of this event's.
        String left = before.evolved().equals(after.evolved()) ? "" : leaving;
        leaving = "";
        record(clock.wallTime(), clock.nanoTime(), occurrence, before, after, outcome, decision, detail, left);
    }

    /** The event whose turn it is leaves a function, {@code where} in words. Called by the thread that carries that event. */
    void leaving(String where) {
        leaving = where;
    }

    /**
     * The same of one that came to its end at {@code time}.
     *
     * @param nanos the same on the clock by which it was observed
     * @param left where it left a function; empty if it left none, or that is not known
     */
    void record(
            Instant time,
            long nanos,
            Occurrence occurrence,
            Configuration before,
            Configuration after,
            Outcome outcome,
            @Nullable Decision decision,
            String detail,
            String left) {
        int place = (int) (recorded++ % size);
        HistoryLine line = lines[place];
        if (line == null) {
            line = new HistoryLine();
            lines[place] = line;
        }
        long took = Math.max(0, nanos - occurrence.observedNanos());
        line.set(recorded, time, took, occurrence, before, after, outcome, decision, detail, left);
    }

    /** How many there have been. */
    long number() {
        return before + recorded;
    }

    /** The last one that was recorded. */
    HistoryEntry last() {
        return Objects.requireNonNull(lines[(int) ((recorded - 1) % size)]).toEntry(before);
    }

    /** Whether {@code count} are there, or all that there have been. */
    boolean reaches(int count) {
        return count <= Math.min(recorded, size) || before + recorded <= Math.min(recorded, size);
    }

    List<HistoryEntry> entries() {
        List<HistoryEntry> entries = new ArrayList<>();
        for (long number = Math.max(0, recorded - size); number < recorded; number++) {
            HistoryLine line = lines[(int) (number % size)];
            if (line != null) {
                entries.add(line.toEntry(before));
            }
        }
        return List.copyOf(entries);
    }
}
