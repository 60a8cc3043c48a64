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
 * The last {@value #SIZE} events and what became of them.
 *
 * <p>Threading: guarded by the lock of the {@link CoreDriver}.
 */
final class History {
    private static final int SIZE = 200;

    private final Clock clock;
    private final HistoryLine[] lines = new HistoryLine[SIZE];
    private long recorded;

    History(Clock clock) {
        this.clock = clock;
    }

    /**
     * Records an event that has come to its end.
     *
     * @param decision what it was found to mean, which tells the detail; null if {@code detail} does
     */
    void record(
            Occurrence occurrence,
            Configuration before,
            Configuration after,
            Outcome outcome,
            @Nullable Decision decision,
            String detail) {
        record(clock.wallTime(), occurrence, before, after, outcome, decision, detail);
    }

    /** The same of one that came to its end at {@code time}. */
    void record(
            Instant time,
            Occurrence occurrence,
            Configuration before,
            Configuration after,
            Outcome outcome,
            @Nullable Decision decision,
            String detail) {
        int place = (int) (recorded++ % SIZE);
        HistoryLine line = lines[place];
        if (line == null) {
            line = new HistoryLine();
            lines[place] = line;
        }
        line.set(recorded, time, occurrence, before, after, outcome, decision, detail);
    }

    /** The last one that was recorded. */
    HistoryEntry last() {
        return Objects.requireNonNull(lines[(int) ((recorded - 1) % SIZE)]).toEntry();
    }

    List<HistoryEntry> entries() {
        List<HistoryEntry> entries = new ArrayList<>();
        for (long number = Math.max(0, recorded - SIZE); number < recorded; number++) {
            HistoryLine line = lines[(int) (number % SIZE)];
            if (line != null) {
                entries.add(line.toEntry());
            }
        }
        return List.copyOf(entries);
    }
}
