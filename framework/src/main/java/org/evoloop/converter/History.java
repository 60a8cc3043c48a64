package org.evoloop.converter;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicLong;
import org.evoloop.converter.HistoryEntry.Outcome;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * The last {@value #SIZE} events and what became of them, and how many had which outcome.
 *
 * <p>Threading: thread-safe.
 */
final class History {
    private static final int SIZE = 200;

    private final Clock clock;
    private final HistoryLine[] lines = new HistoryLine[SIZE];
    private final Map<Outcome, AtomicLong> counts = new EnumMap<>(Outcome.class);
    private long recorded;

    History(Clock clock) {
        this.clock = clock;
        for (Outcome outcome : Outcome.values()) {
            counts.put(outcome, new AtomicLong());
        }
    }

    /**
     * Records an event that has come to its end.
     *
     * @param decision what it was found to mean, which tells the detail; null if {@code detail} does
     */
    synchronized void record(
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
        line.set(recorded, clock.wallTime(), occurrence, before, after, outcome, decision, detail);
        count(outcome).incrementAndGet();
    }

    synchronized List<HistoryEntry> entries() {
        List<HistoryEntry> entries = new ArrayList<>();
        for (long number = Math.max(0, recorded - SIZE); number < recorded; number++) {
            HistoryLine line = lines[(int) (number % SIZE)];
            if (line != null) {
                entries.add(line.toEntry());
            }
        }
        return List.copyOf(entries);
    }

    synchronized ConverterStatus.EventCounts counts() {
        return new ConverterStatus.EventCounts(
                count(Outcome.HANDLED).get(),
                count(Outcome.IGNORED).get(),
                count(Outcome.STALE).get(),
                count(Outcome.FAILED).get());
    }

    private AtomicLong count(Outcome outcome) {
        return Objects.requireNonNull(counts.get(outcome));
    }
}
