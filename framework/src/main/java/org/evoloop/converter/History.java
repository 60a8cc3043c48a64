package org.evoloop.converter;

import java.util.ArrayList;
import java.util.List;
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
    private final long[] counts = new long[Outcome.values().length];
    private long recorded;

    History(Clock clock) {
        this.clock = clock;
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
        counts[placeOf(outcome)]++;
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
                count(Outcome.HANDLED), count(Outcome.IGNORED), count(Outcome.STALE), count(Outcome.FAILED));
    }

    private long count(Outcome outcome) {
        return counts[placeOf(outcome)];
    }

    @SuppressWarnings("EnumOrdinal") // a map would box a number in every event
    private static int placeOf(Outcome outcome) {
        return outcome.ordinal();
    }
}
