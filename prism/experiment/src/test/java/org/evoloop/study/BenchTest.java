package org.evoloop.study;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.study.Point.Mechanism;
import org.junit.jupiter.api.Test;

class BenchTest {
    private static final long HOUR_NANOS = Duration.ofHours(1).toNanos();
    private static final long SEED = 17;

    private final List<Duration> waits = new ArrayList<>();

    private static Point point(Mechanism mechanism, int capacity, int steps) {
        return new Point("test", mechanism, capacity, steps, 0.5, 0.25, 1, 1, SEED);
    }

    private Bench afterAnHour(Point point) {
        Bench bench = new Bench(point, point.seed(), waits::add);
        while (bench.clock.nanoTime() < HOUR_NANOS) {
            bench.go();
        }
        return bench;
    }

    @Test
    void backPressureLosesNothingInTheDeviceAndNeverDiverges() {
        for (Mechanism mechanism : List.of(Mechanism.SERIAL, Mechanism.PIPELINED)) {
            for (int steps = 1; steps <= 2; steps++) {
                try (Bench bench = afterAnHour(point(mechanism, 2, steps))) {
                    assertThat(bench.lost()).as("in the full queue").isPositive();
                    assertThat(bench.device.lost()).as("in the device").isZero();
                    assertThat(bench.divergedNanos()).isNegative();
                }
            }
        }
    }

    @Test
    void withoutBackPressureTheDeviceLosesEventsAndTheBeliefIsWrong() {
        for (Mechanism mechanism : List.of(Mechanism.UNBUFFERED, Mechanism.HOLDOFF)) {
            try (Bench bench = afterAnHour(point(mechanism, 1, 1))) {
                assertThat(bench.device.lost()).isPositive();
                assertThat(bench.divergedNanos()).isPositive();
            }
        }
    }

    @Test
    void everyEventIsLostOrActedOnOrStillInTheConverter() {
        for (int capacity : new int[] {1, 2, 8}) {
            try (Bench bench = afterAnHour(point(Mechanism.PIPELINED, capacity, 1))) {
                long held = bench.arrived() - bench.lost() - bench.device.actions();
                assertThat(held).isBetween(0L, (long) capacity);
                assertThat(waits).hasSize((int) bench.device.actions());
                waits.clear();
            }
        }
    }

    @Test
    void aDecisionOfTwoEventsTakesTwoActions() {
        try (Bench bench = afterAnHour(point(Mechanism.PIPELINED, 4, 2))) {
            assertThat(bench.device.actions()).isEqualTo(2L * waits.size());
        }
    }

    @Test
    void theSameSeedGivesTheSameRun() {
        try (Bench one = afterAnHour(point(Mechanism.PIPELINED, 2, 1));
                Bench other = afterAnHour(point(Mechanism.PIPELINED, 2, 1))) {
            assertThat(one.lost()).isEqualTo(other.lost());
            assertThat(one.clock.nanoTime()).isEqualTo(other.clock.nanoTime());
        }
    }
}
