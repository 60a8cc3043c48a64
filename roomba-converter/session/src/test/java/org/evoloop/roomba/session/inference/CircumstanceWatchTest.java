package org.evoloop.roomba.session.inference;

import static org.assertj.core.api.Assertions.assertThat;

import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.session.Frames;
import org.junit.jupiter.api.Test;

/** What frames reveal about the robot's place and condition. */
class CircumstanceWatchTest {
    private static final SensorValues PASSIVE = Frames.resting(OiMode.PASSIVE);
    private static final SensorValues DOCKED =
            PASSIVE.with(Packet.CHARGING_SOURCES, 2).with(Packet.CHARGING_STATE, 2);
    private static final int FIVE_MINUTES = 5 * 60_000 / 15;

    private final CircumstanceWatch watch = new CircumstanceWatch();

    private boolean frames(int count, SensorValues values, boolean atWork) {
        boolean news = false;
        for (int frame = 0; frame < count; frame++) {
            news |= watch.update(values, atWork);
        }
        return news;
    }

    @Test
    void aSingleFrameMayBeCorrupted() {
        assertThat(frames(10, PASSIVE, false)).isFalse();
        assertThat(frames(2, DOCKED, false)).isFalse();
        assertThat(frames(1, PASSIVE, false)).isFalse();
        assertThat(frames(3, DOCKED, false)).isTrue();
        assertThat(watch.now()).isEqualTo(new Circumstances(false, false, true, true));
        assertThat(frames(100, DOCKED, false)).isFalse();
    }

    @Test
    void aFullBatteryIsKeptSo() {
        frames(3, DOCKED, false);
        assertThat(frames(3, DOCKED.with(Packet.CHARGING_STATE, 3), false)).isTrue();
        assertThat(watch.now().filling()).isFalse();
        assertThat(watch.now().docked()).isTrue();
    }

    @Test
    void aWheelInTheAirAndAMotorThatIsStuckAreTrouble() {
        frames(3, PASSIVE.with(Packet.BUMPS_AND_WHEEL_DROPS, 0b1000), false);
        assertThat(watch.now().inTrouble()).isTrue();
        frames(3, PASSIVE, false);
        assertThat(watch.now()).isEqualTo(Circumstances.USUAL);
        frames(3, PASSIVE.with(Packet.OVERCURRENTS, 1), false);
        assertThat(watch.now().inTrouble()).isTrue();
    }

    @Test
    void onlyAnUnusedRobotIsDrowsy() {
        frames(FIVE_MINUTES, Frames.resting(OiMode.SAFE), false);
        assertThat(watch.isDrowsy()).as("under control it never sleeps").isFalse();
        frames(FIVE_MINUTES, PASSIVE, true);
        assertThat(watch.isDrowsy()).as("at work it does not sleep").isFalse();
        frames(FIVE_MINUTES, PASSIVE, false);
        assertThat(watch.isDrowsy()).isTrue();
        frames(10, PASSIVE.with(Packet.BUTTONS, 1), false);
        assertThat(watch.isDrowsy()).as("a press keeps it awake").isFalse();
    }

    @Test
    void onItsDockAnIdleRobotMayFallAsleepAtAnyTime() {
        frames(10, DOCKED, true);
        assertThat(watch.isDrowsy()).as("it is about to leave").isFalse();
        frames(10, DOCKED, false);
        assertThat(watch.isDrowsy()).isTrue();
        frames(10, PASSIVE, false);
        assertThat(watch.isDrowsy()).isFalse();
    }

    @Test
    void aCorruptedFrameDoesNotKeepItAwake() {
        for (int second = 0; second < 300; second++) {
            frames(66, PASSIVE, false);
            frames(1, PASSIVE.with(Packet.BUTTONS, 4), false);
        }
        assertThat(watch.isDrowsy()).isTrue();
    }

    @Test
    void asleepItIsUntilFramesCome() {
        frames(FIVE_MINUTES, PASSIVE, false);
        assertThat(watch.fellAsleep()).isTrue();
        assertThat(watch.now().asleep()).isTrue();
        assertThat(watch.isDrowsy()).isFalse();
        assertThat(frames(3, PASSIVE, false)).isTrue();
        assertThat(watch.now()).isEqualTo(Circumstances.USUAL);
    }
}
