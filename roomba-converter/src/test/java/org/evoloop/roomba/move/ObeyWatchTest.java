package org.evoloop.roomba.move;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.PacketGroup;
import org.evoloop.roomba.oi.SensorValues;
import org.junit.jupiter.api.Test;

class ObeyWatchTest {
    private static final int FRAME_MILLIS = 15;

    private final ObeyWatch watch = new ObeyWatch(nanos(300));
    private long nowMillis;
    private int left;
    private int right;

    private static long nanos(long millis) {
        return millis * 1_000_000;
    }

    private void drive(int rightMmPerS, int leftMmPerS) {
        watch.commanded(new DriveDirect(rightMmPerS, leftMmPerS), nanos(nowMillis));
    }

    /**
     * The wheels turn by this many counts per frame; returns the ms after which that was found wrong, -1 if it was not.
     */
    private long turn(int rightCounts, int leftCounts, int millis, boolean underControl) {
        long began = nowMillis;
        while (nowMillis - began < millis) {
            nowMillis += FRAME_MILLIS;
            right += rightCounts;
            left += leftCounts;
            if (watch.update(values(), underControl, nanos(nowMillis))) {
                return nowMillis - began;
            }
        }
        return -1;
    }

    private SensorValues values() {
        return SensorValues.of(
                List.of(PacketGroup.values()),
                packet -> packet == Packet.LEFT_ENCODER
                        ? (short) left
                        : packet == Packet.RIGHT_ENCODER
                                ? (short) right
                                : packet == Packet.OI_MODE ? OiMode.SAFE.code() : 0);
    }

    @Test
    void aRobotThatObeysIsFoundRight() {
        drive(85, 85);
        assertThat(turn(3, 3, 3_000, true)).isEqualTo(-1);
        drive(-40, 40);
        assertThat(turn(3, 3, 150, true)).as("it needs a moment").isEqualTo(-1);
        assertThat(turn(-1, 1, 3_000, true)).isEqualTo(-1);
        drive(0, 0);
        assertThat(turn(-1, 1, 150, true)).isEqualTo(-1);
        assertThat(turn(0, 0, 3_000, true)).isEqualTo(-1);
    }

    @Test
    void aRobotThatKeepsObeyingAnEarlierCommandIsDetectedWithin2Seconds() {
        drive(85, 85);
        turn(3, 3, 1_000, true);
        drive(0, 0);
        assertThat(turn(3, 3, 5_000, true)).isBetween(1_000L, 2_000L);
        assertThat(turn(3, 3, 5_000, true)).as("reported once").isEqualTo(-1);
    }

    @Test
    void aWheelThatStandsStillDespiteACommandIsDetected() {
        drive(0, 0);
        turn(0, 0, 1_000, true);
        drive(85, 85);
        assertThat(turn(3, 0, 5_000, true)).isBetween(1_000L, 2_000L);
    }

    @Test
    void aRobotOutOfControlDoesNotObey() {
        drive(85, 85);
        assertThat(turn(0, 0, 5_000, false)).isEqualTo(-1);
    }

    @Test
    void phasesThatChangeFasterThanItReactsAreNoProof() {
        for (int turn = 0; turn < 20; turn++) {
            drive(85, 85);
            assertThat(turn(0, 0, 210, true)).isEqualTo(-1);
            drive(0, 0);
            assertThat(turn(0, 0, 210, true)).isEqualTo(-1);
        }
    }
}
