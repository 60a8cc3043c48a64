package org.evoloop.time;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;

class AttemptsTest {
    private final Attempts attempts = new Attempts();

    @Test
    void pausesDoubleUpToTheLongest() {
        assertThat(attempts.pause()).isEqualTo(Duration.ofMillis(250));
        assertThat(attempts.pause()).isEqualTo(Duration.ofMillis(500));
        for (int i = 0; i < 5; i++) {
            attempts.pause();
        }
        assertThat(attempts.pause()).isEqualTo(Duration.ofSeconds(30));
        assertThat(attempts.pause()).isEqualTo(Duration.ofSeconds(30));
    }

    @Test
    void aFaultIsNewsOnce() {
        assertThat(attempts.failed("refused", 0)).isTrue();
        assertThat(attempts.failed("refused", 1)).isFalse();
        assertThat(attempts.failed("no such host", 2)).isTrue();
    }

    @Test
    void whatHasLastedBeginsAnew() {
        attempts.failed("refused", 0);
        attempts.pause();
        assertThat(attempts.succeeded(0)).isTrue();
        assertThat(attempts.succeeded(1)).isFalse();
        assertThat(attempts.failed("refused", Attempts.STABLE.toNanos())).isTrue();
        assertThat(attempts.pause()).isEqualTo(Attempts.FIRST);
    }

    @Test
    void whatIsLostAtOnceIsOneMoreFailedAttempt() {
        attempts.failed("refused", 0);
        attempts.pause();
        attempts.succeeded(0);
        assertThat(attempts.failed("refused", Attempts.STABLE.toNanos() - 1)).isFalse();
        assertThat(attempts.pause()).isEqualTo(Attempts.FIRST.multipliedBy(2));
    }
}
