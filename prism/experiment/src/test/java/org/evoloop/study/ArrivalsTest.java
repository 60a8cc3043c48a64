package org.evoloop.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class ArrivalsTest {
    private final Arrivals arrivals = new Arrivals();

    @Test
    void whatIsNeverHandedOverIsLostAtItsArrival() {
        for (long nanos : new long[] {10, 20, 30, 40}) {
            arrivals.arrive(nanos);
        }
        arrivals.handOver(10, 15);
        arrivals.handOver(40, 41);

        assertThat(arrivals.lost(0, 19)).isZero();
        assertThat(arrivals.lost(0, 20)).isOne();
        assertThat(arrivals.lost(20, 40)).isOne();
        assertThat(arrivals.size()).isEqualTo(4);
        List<Duration> waits = new ArrayList<>();
        arrivals.waits(10, 40, waits::add);
        assertThat(waits).containsExactly(Duration.ofNanos(1));
    }

    @Test
    void noEventIsHandedOverTwiceOrOutOfTheBlue() {
        arrivals.arrive(10);
        arrivals.handOver(10, 15);
        assertThatThrownBy(() -> arrivals.handOver(10, 16)).hasMessageContaining("10 ns twice");
        assertThatThrownBy(() -> arrivals.handOver(11, 16)).hasMessageContaining("11 ns that never arrived");
        assertThatThrownBy(() -> arrivals.arrive(10)).hasMessageContaining("two events arrived at 10 ns");
    }

    @Test
    void aLogCountsUpToAMoment() {
        TimeLog log = new TimeLog();
        assertThat(log.until(100)).isZero();
        for (int number = 1; number <= 40; number++) {
            log.add(10L * (number / 2));
        }
        assertThat(log.size()).isEqualTo(40);
        assertThat(log.at(1)).isZero();
        assertThat(log.at(3)).isEqualTo(10);
        assertThat(log.until(-1)).isZero();
        assertThat(log.until(10)).isEqualTo(3);
        assertThat(log.until(19)).isEqualTo(3);
        assertThat(log.until(200)).isEqualTo(40);
    }
}
