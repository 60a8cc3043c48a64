package org.evoloop.study;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.study.Point.Mechanism;
import org.junit.jupiter.api.Test;

class BenchTest {
    private static final long SEED = 17;

    private static Point point(Mechanism mechanism, int capacity, int steps) {
        return new Point(
                "test",
                mechanism,
                capacity,
                steps,
                0.5,
                ConversionTime.exponential(0.25),
                1,
                1,
                Disturbances.NONE,
                SEED);
    }

    private static Bench afterAnHour(Point point) {
        return after(Duration.ofHours(1), point, false);
    }

    private static Bench after(Duration time, Point point, boolean threads) {
        Bench bench = new Bench(point, point.seed(), threads);
        while (bench.time.nanos() < time.toNanos()) {
            bench.go();
        }
        return bench;
    }

    private static long lost(Bench bench) {
        return bench.arrivals.lost(0, Long.MAX_VALUE);
    }

    private static List<Duration> waits(Bench bench) {
        List<Duration> waits = new ArrayList<>();
        bench.arrivals.waits(0, Long.MAX_VALUE, waits::add);
        return waits;
    }

    @Test
    void backPressureLosesNothingInTheDeviceAndNeverDiverges() {
        for (Mechanism mechanism : List.of(Mechanism.SERIAL, Mechanism.PIPELINED)) {
            for (int steps = 1; steps <= 2; steps++) {
                try (Bench bench = afterAnHour(point(mechanism, 2, steps))) {
                    assertThat(lost(bench)).as("in the full queue").isPositive();
                    assertThat(bench.device.lost().size()).as("in the device").isZero();
                    assertThat(bench.agreement.divergedNanos()).isNegative();
                }
            }
        }
    }

    @Test
    void withoutBackPressureTheDeviceLosesEventsAndTheBeliefIsWrong() {
        for (Mechanism mechanism : List.of(Mechanism.UNBUFFERED, Mechanism.HOLDOFF)) {
            try (Bench bench = afterAnHour(point(mechanism, 1, 1))) {
                assertThat(bench.device.lost().size()).isPositive();
                assertThat(bench.agreement.divergedNanos()).isPositive();
            }
        }
    }

    @Test
    void everyEventIsLostOrActedOn() {
        for (int capacity : new int[] {1, 2, 8}) {
            try (Bench bench = afterAnHour(point(Mechanism.PIPELINED, capacity, 1))) {
                assertThat(bench.device.ready().size()).isEqualTo((int) (bench.arrivals.size() - lost(bench)));
                assertThat(waits(bench)).hasSize(bench.device.ready().size());
            }
        }
    }

    @Test
    void aDecisionOfTwoEventsTakesTwoActions() {
        try (Bench bench = afterAnHour(point(Mechanism.PIPELINED, 4, 2))) {
            assertThat(bench.device.ready().size()).isEqualTo(2 * waits(bench).size());
        }
    }

    @Test
    void theSameSeedGivesTheSameRunWithAndWithoutThreads() {
        Duration time = Duration.ofMinutes(20);
        for (Mechanism mechanism : Mechanism.values()) {
            for (int capacity = 1; capacity <= 3; capacity++) {
                Point point = point(mechanism, capacity, 1);
                try (Bench one = after(time, point, false);
                        Bench again = after(time, point, false);
                        Bench threads = after(time, point, true)) {
                    assertThat(waits(again)).isEqualTo(waits(one));
                    assertThat(waits(threads)).as(point.toString()).isEqualTo(waits(one));
                    assertThat(lost(threads)).isEqualTo(lost(one));
                    assertThat(threads.device.lost().size())
                            .isEqualTo(one.device.lost().size());
                    assertThat(threads.time.nanos()).isEqualTo(one.time.nanos());
                }
            }
        }
    }
}
