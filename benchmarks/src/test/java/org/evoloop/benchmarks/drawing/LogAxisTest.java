package org.evoloop.benchmarks.drawing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;

class LogAxisTest {
    @Test
    void reachesFromTheDecadeBelowToTheDecadeAbove() {
        LogAxis axis = LogAxis.over(DoubleStream.of(700, 9.1, 14), 100, 300);

        assertThat(axis.marks()).containsExactly(1.0, 10.0, 100.0, 1000.0);
        assertThat(axis.x(1)).isEqualTo(100);
        assertThat(axis.x(1000)).isEqualTo(400);
        assertThat(axis.x(Math.sqrt(1000))).isCloseTo(250, within(1e-9));
    }

    @Test
    void hasADecadeEvenForOneValue() {
        assertThat(LogAxis.over(DoubleStream.of(10), 0, 100).marks()).containsExactly(10.0, 100.0);
    }
}
