package org.evoloop.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import org.junit.jupiter.api.Test;

class SamplesTest {
    @Test
    void sumsValuesUp() {
        Samples samples = new Samples();
        assertThat(samples.deviation()).isZero();
        for (double value : new double[] {2, 4, 4, 4, 5, 5, 7, 9}) {
            samples.add(value);
        }
        assertThat(samples.number()).isEqualTo(8);
        assertThat(samples.mean()).isCloseTo(5, within(1e-12));
        assertThat(samples.deviation()).isCloseTo(Math.sqrt(32.0 / 7), within(1e-12));
    }

    @Test
    void distinguishesWaitsByWholeSeconds() {
        WaitBatch batch = new WaitBatch(2);
        for (long millis : new long[] {500, 1000, 1500, 9000}) {
            batch.add(Duration.ofMillis(millis));
        }
        assertThat(batch.meanSeconds()).isEqualTo(3);
        assertThat(batch.shareLongerThan(1)).isEqualTo(0.5);
        assertThat(batch.shareLongerThan(2)).isEqualTo(0.25);
    }
}
