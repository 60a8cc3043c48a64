package org.evoloop.roomba.session;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.function.Reading;
import org.evoloop.roomba.oi.ChargingState;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.SensorValues;

/**
 * The readings of a frame, for people and programs. The bin is not included: no packet of the Open Interface shows
 * whether it is full or missing.
 *
 * <ul>
 *   <li>{@code battery}, %: charge by capacity (packets 25 and 26); absent while the robot reports no capacity
 *   <li>{@code docked}: it is on its home base (34); {@code charging}: a charger fills its battery, or keeps it
 *   full (21)
 *   <li>{@code lifted}: a wheel hangs in the air (7); {@code stuck}: a motor draws too much current (14)
 *   <li>{@code error}: what prevents it from working, in words, or {@code none}
 *   <li>{@code asleep}: it ignores commands until it is woken; {@code mode}: its OI mode (35), in lower case
 * </ul>
 */
final class RobotReadings {
    /** Bits of packet 14. */
    private static final List<String> MOTORS = List.of("side brush", "", "main brush", "right wheel", "left wheel");

    private RobotReadings() {}

    static List<Reading> of(SensorValues values, boolean asleep) {
        return Stream.of(
                        battery(values),
                        Stream.of(
                                Reading.of("docked", values.onHomeBase()),
                                Reading.of("charging", isCharging(values)),
                                Reading.of("lifted", values.anyWheelDrop()),
                                Reading.of("stuck", values.anyOvercurrent()),
                                Reading.of("error", error(values)),
                                Reading.of("asleep", asleep),
                                Reading.of(
                                        "mode",
                                        values.mode()
                                                .map(OiMode::name)
                                                .orElse("unknown")
                                                .toLowerCase(Locale.ROOT))))
                .flatMap(readings -> readings)
                .toList();
    }

    private static Stream<Reading> battery(SensorValues values) {
        return values.batteryPercent().stream().mapToObj(percent -> Reading.of("battery", percent, "%"));
    }

    private static boolean isCharging(SensorValues values) {
        return values.chargingState()
                .filter(state -> state == ChargingState.RECONDITIONING
                        || state == ChargingState.FULL_CHARGING
                        || state == ChargingState.TRICKLE_CHARGING)
                .isPresent();
    }

    private static String error(SensorValues values) {
        int overcurrents = values.value(Packet.OVERCURRENTS);
        String motors = MOTORS.stream()
                .filter(motor -> !motor.isEmpty() && (overcurrents & 1 << MOTORS.indexOf(motor)) != 0)
                .collect(Collectors.joining(", "));
        String charger =
                values.chargingState().filter(ChargingState.FAULT::equals).isPresent() ? "charging fault" : "";
        String all = Stream.of(
                        values.anyWheelDrop() ? "a wheel hangs in the air" : "",
                        motors.isEmpty() ? "" : "too much current: " + motors,
                        charger)
                .filter(words -> !words.isEmpty())
                .collect(Collectors.joining("; "));
        return all.isEmpty() ? "none" : all;
    }
}
