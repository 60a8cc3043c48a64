package org.evoloop.benchmarks.running;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SplittableRandom;
import org.HdrHistogram.Histogram;
import org.junit.jupiter.api.Test;

class CameraTurnsTest {
    private static final long SEED = 7;
    private static final int PAIRS = 20;
    private static final int EVENTS = 200;

    /** Significant digits of the recorded values; with each one more, the table takes ten times as long. */
    private static final int DIGITS = 2;

    private final SplittableRandom random = new SplittableRandom(SEED);
    private final CameraTurns turns = new CameraTurns();

    /** Events of 50 to 70 us, in turns that differ by up to 10 us as on a real machine. */
    private Histogram turn(long moreNanos, double late, long lateNanos) {
        Histogram nanos = new Histogram(1_000_000_000L, DIGITS);
        long turnNanos = random.nextLong(10_000);
        for (int event = 0; event < EVENTS; event++) {
            boolean isLate = random.nextDouble() < late;
            nanos.recordValue(50_000 + turnNanos + random.nextLong(10_000) + moreNanos + (isLate ? lateNanos : 0));
        }
        return nanos;
    }

    private List<String> rows() {
        return turns.table().lines().skip(1).toList();
    }

    @Test
    void turnsOfOneKindShowNoCost() {
        for (int pair = 0; pair < PAIRS; pair++) {
            turns.add(turn(0, 0.02, 500_000), turn(0, 0.02, 500_000));
        }

        assertThat(rows()).hasSize(4).allMatch(row -> row.endsWith("none that can be measured"));
    }

    @Test
    void aFewLateEventsAreACostOfTheTailAlone() {
        for (int pair = 0; pair < PAIRS; pair++) {
            turns.add(turn(0, 0, 0), turn(0, 0.03, 2_000_000));
        }

        assertThat(rows().subList(0, 2)).allMatch(row -> row.endsWith("none that can be measured"));
        assertThat(rows().subList(2, 4)).allMatch(row -> row.endsWith("  measured"));
    }

    @Test
    void whatEveryEventPaysIsMeasuredAtTheMedian() {
        for (int pair = 0; pair < PAIRS; pair++) {
            turns.add(turn(0, 0, 0), turn(20_000, 0, 0));
        }

        assertThat(rows().get(0))
                .startsWith("p50")
                .containsPattern("\\+(19|2[01])\\.\\d,")
                .endsWith("  measured");
    }
}
