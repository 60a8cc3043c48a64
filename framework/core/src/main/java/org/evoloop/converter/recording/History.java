package org.evoloop.converter.recording;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.running.CoreDriver;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * The last events and their outcomes, {@value #SIZE} by default.
 *
 * <p>Threading: guarded by the lock of the {@link CoreDriver}.
 */
public final class History {
    private static final int SIZE = 200;

    private final Clock clock;
    private final HistoryLine[] lines;
    private final int size;
    private long recorded;

    /** How many events were recorded elsewhere before the first one here. */
    private long before;

    History(Clock clock) {
        this(clock, SIZE);
    }

    /** @param size how many are kept */
    public History(Clock clock, int size) {
        this.clock = clock;
        this.size = size;
        this.lines = new HistoryLine[size];
    }

    /** Sets the number of the last recorded event. */
    public void countOn(long number) {
        before = Math.max(0, number - recorded);
    }

    /**
     * Records an event that has ended.
     *
     * @param decision its decision, which gives the detail; null if {@code detail} gives it
     * @param left the progress of the function that it left; empty if it left none
     */
    void record(
            Occurrence occurrence,
            Configuration before,
            Configuration after,
            Outcome outcome,
            @Nullable Decision decision,
            String detail,
            String left) {
        record(clock.wallTime(), clock.nanoTime(), occurrence, before, after, outcome, decision, detail, left);
    }

    /**
     * Records an event that ended at {@code time}.
     *
     * @param nanos the same time on the clock of its observation
     * @param left the progress of the function that it left; empty if it left none, or that is unknown
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

    /** The number of events so far. */
    public long number() {
        return before + recorded;
    }

    /** The last recorded event. */
    HistoryEntry last() {
        return Objects.requireNonNull(lines[(int) ((recorded - 1) % size)]).toEntry(before);
    }

    /** Whether {@code count} entries are in memory, or all that there have been. */
    public boolean reaches(int count) {
        return count <= Math.min(recorded, size) || before + recorded <= Math.min(recorded, size);
    }

    public List<HistoryEntry> entries() {
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
