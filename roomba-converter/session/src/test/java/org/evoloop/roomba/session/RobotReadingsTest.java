package org.evoloop.roomba.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.Collectors;
import org.evoloop.function.Reading;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.SensorValues;
import org.junit.jupiter.api.Test;

/** A robot's readings, in the words that {@code status} shows. */
class RobotReadingsTest {
    private static final SensorValues PASSIVE =
            Frames.resting(OiMode.PASSIVE).with(Packet.BATTERY_CAPACITY, 2_696).with(Packet.BATTERY_CHARGE, 2_507);

    private static String readings(SensorValues values) {
        return RobotReadings.of(values, false).stream().map(Reading::toString).collect(Collectors.joining(", "));
    }

    @Test
    void aRobotOnTheFloor() {
        assertThat(readings(PASSIVE))
                .isEqualTo(
                        "battery 93 %, not docked, not charging, not lifted, not stuck, error none, not asleep, mode passive");
    }

    @Test
    void aRobotOnItsDock() {
        assertThat(readings(PASSIVE.with(Packet.CHARGING_SOURCES, 2).with(Packet.CHARGING_STATE, 2)))
                .contains(" docked, charging,");
        assertThat(readings(PASSIVE.with(Packet.CHARGING_SOURCES, 2).with(Packet.CHARGING_STATE, 4)))
                .contains(" docked, not charging,");
        assertThat(readings(PASSIVE.with(Packet.CHARGING_STATE, 5))).contains("error charging fault");
    }

    @Test
    void aRobotInTrouble() {
        assertThat(readings(PASSIVE.with(Packet.BUMPS_AND_WHEEL_DROPS, 0b0100)))
                .contains("lifted, not stuck, error a wheel hangs in the air");
        assertThat(readings(PASSIVE.with(Packet.OVERCURRENTS, 0b10100)))
                .contains("stuck, error too much current: main brush, left wheel");
    }

    @Test
    void anOddBatteryIsBelievedWithinReason() {
        assertThat(readings(PASSIVE.with(Packet.BATTERY_CHARGE, 65_500))).startsWith("battery 0 %");
        assertThat(readings(PASSIVE.with(Packet.BATTERY_CHARGE, 2_900))).startsWith("battery 100 %");
        assertThat(readings(PASSIVE.with(Packet.BATTERY_CAPACITY, 0))).startsWith("not docked");
    }
}
