package org.evoloop.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Percentage.withPercentage;

import java.time.Duration;
import org.evoloop.study.Point.Mechanism;
import org.junit.jupiter.api.Test;

class DisturbedBenchTest {
    private static final long DAY_NANOS = Duration.ofDays(1).toNanos();

    /** A queue so long that no event is lost in it. */
    private static final int ROOM = 200;

    private static Bench afterADay(Disturbances disturbances) {
        Point point = new Point(
                "test", Mechanism.PIPELINED, ROOM, 1, 0.5, ConversionTime.exponential(0.25), 1, 0, disturbances, 17);
        Bench bench = new Bench(point, point.seed(), false);
        while (bench.time.nanos() < DAY_NANOS) {
            bench.go();
        }
        return bench;
    }

    private static Disturbances crashes(boolean journal) {
        return new Disturbances(120, 5, journal, 0, 0, 0, 0, 0);
    }

    private static double lostPerSecond(Bench bench) {
        return bench.arrivals.lost(0, DAY_NANOS) / (DAY_NANOS / 1e9);
    }

    @Test
    void withAJournalACrashLosesOnlyWhatComesWhileNoProcessRuns() {
        try (Bench bench = afterADay(crashes(true))) {
            assertThat(lostPerSecond(bench)).isBetween(0.5 * 5 / 125 * 0.8, 0.5 * 5 / 125 * 1.2);
            assertThat(bench.agreement.divergedNanos()).isNegative();
            assertThat(bench.device.lost().size()).isZero();
        }
    }

    @Test
    void withoutAJournalItLosesWhatWaitsToo() {
        try (Bench with = afterADay(crashes(true));
                Bench without = afterADay(crashes(false))) {
            assertThat(lostPerSecond(without)).isGreaterThan(1.2 * lostPerSecond(with));
            assertThat(without.agreement.divergedNanos()).isPositive();
            assertThat(without.agreement.wrongNanos(0, DAY_NANOS) / (double) DAY_NANOS)
                    .as("two out of three while a process runs")
                    .isBetween(0.56, 0.72);
        }
    }

    @Test
    void aLinkThatBreaksCostsTimeAndNoEvents() {
        try (Bench bench = afterADay(new Disturbances(0, 0, false, 60, 20, 0, 0, 0));
                Bench calm = afterADay(Disturbances.NONE)) {
            assertThat(lostPerSecond(bench)).isZero();
            assertThat(bench.agreement.divergedNanos()).isNegative();
            assertThat(meanWait(bench)).isGreaterThan(3 * meanWait(calm));
        }
    }

    private static double meanWait(Bench bench) {
        WaitBatch batch = new WaitBatch(1);
        bench.arrivals.waits(0, DAY_NANOS, batch::add);
        return batch.meanSeconds();
    }

    @Test
    void aDeviceThatIsOperatedIsWhereItIsFound() {
        try (Bench bench = afterADay(new Disturbances(0, 0, false, 60, 20, 0.1, 0, 0))) {
            assertThat(bench.agreement.wrongNanos(0, DAY_NANOS) / (double) DAY_NANOS)
                    .as("only while the robot is unreachable")
                    .isBetween(0.1, 0.25);
            assertThat(bench.device.lost().size()).isZero();
        }
    }

    @Test
    void noSwapLosesAnEvent() {
        try (Bench bench = afterADay(new Disturbances(0, 0, false, 0, 0, 0, 30, 2));
                Bench calm = afterADay(Disturbances.NONE)) {
            assertThat(lostPerSecond(bench)).isZero();
            assertThat(bench.agreement.divergedNanos()).isNegative();
            assertThat(bench.arrivals.handedOver(DAY_NANOS))
                    .isCloseTo(calm.arrivals.handedOver(DAY_NANOS), withPercentage(1));
        }
    }
}
