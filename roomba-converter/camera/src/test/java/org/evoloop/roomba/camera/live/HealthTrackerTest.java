package org.evoloop.roomba.camera.live;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.evoloop.roomba.camera.CameraHealth;
import org.evoloop.roomba.camera.CameraHealth.Condition;
import org.junit.jupiter.api.Test;

class HealthTrackerTest {
    private static final long SECOND = 1_000_000_000L;

    private final HealthTracker health = new HealthTracker("camera x", Duration.ofMillis(300));

    private void assertHealth(long nanos, Condition state, String reason) {
        assertThat(health.at(nanos)).isEqualTo(new CameraHealth(state, reason));
    }

    @Test
    void opensThenSeesThenStallsWithTimeAlone() {
        assertHealth(0, Condition.OPENING, "camera x is being opened");
        health.seeing(SECOND);
        assertHealth(SECOND + 300_000_000, Condition.SEEING, "");
        assertHealth(
                SECOND + 301_000_000,
                Condition.STALLED,
                "camera x has sent no frame for 0.3 s; check its cable and power");
        health.seeing(2 * SECOND);
        assertHealth(2 * SECOND, Condition.SEEING, "");
    }

    @Test
    void distinguishesDamagedFramesFromNone() {
        health.seeing(SECOND);
        health.damaged();
        health.damaged();
        assertHealth(SECOND, Condition.SEEING, "");
        assertHealth(
                3 * SECOND,
                Condition.STALLED,
                "camera x has sent 2 damaged frames and no good one for 2.0 s; check its cable, or ask it for smaller "
                        + "frames");
    }

    @Test
    void remembersWhyItWasGoneWhileItTriesAgain() {
        health.gone("camera x does not exist; plug it in");
        assertHealth(0, Condition.GONE, "camera x does not exist; plug it in");
        health.opening();
        assertHealth(0, Condition.OPENING, "trying again: camera x does not exist; plug it in");
    }

    @Test
    void staysClosed() {
        health.closed();
        health.seeing(SECOND);
        health.gone("late");
        health.opening();
        health.blind("late");
        assertHealth(SECOND, Condition.CLOSED, "camera x is closed");
    }
}
