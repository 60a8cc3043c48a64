package org.evoloop.converter;

import java.util.ArrayDeque;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.evoloop.converter.HistoryEntry.Outcome;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;
import org.evoloop.time.Clock;

/**
 * The last {@value #SIZE} events and what became of them, and how many had which outcome.
 *
 * <p>Threading: thread-safe.
 */
final class History {
    private static final int SIZE = 200;

    private final Clock clock;
    private final ArrayDeque<HistoryEntry> entries = new ArrayDeque<>();
    private final Map<Outcome, Long> counts = new EnumMap<>(Outcome.class);
    private long number;

    History(Clock clock) {
        this.clock = clock;
    }

    synchronized void record(
            Occurrence occurrence, Configuration before, Configuration after, Outcome outcome, String detail) {
        if (entries.size() == SIZE) {
            entries.removeFirst();
        }
        number++;
        entries.addLast(new HistoryEntry(number, clock.wallTime(), occurrence, before, after, outcome, detail));
        counts.merge(outcome, 1L, Long::sum);
    }

    synchronized List<HistoryEntry> entries() {
        return List.copyOf(entries);
    }

    synchronized ConverterStatus.EventCounts counts() {
        return new ConverterStatus.EventCounts(
                count(Outcome.HANDLED), count(Outcome.IGNORED), count(Outcome.STALE), count(Outcome.FAILED));
    }

    private long count(Outcome outcome) {
        return counts.getOrDefault(outcome, 0L);
    }
}
