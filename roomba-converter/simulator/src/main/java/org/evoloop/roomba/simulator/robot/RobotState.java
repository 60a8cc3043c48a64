package org.evoloop.roomba.simulator.robot;

import java.util.Collection;
import java.util.Comparator;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.simulator.body.Surroundings;
import org.evoloop.roomba.simulator.room.Pose;

/**
 * The true state of a simulated robot at one moment, independent of its sensors.
 *
 * @param timeMillis since the robot was created
 * @param pose the position of the robot's centre in its room, and its heading
 * @param leftMmPerS the left wheel's speed
 * @param rightMmPerS the right wheel's speed
 * @param pressed the buttons held down
 * @param streaming whether frames are being sent
 * @param surroundings the bumps, cliffs, wheel drops and dock at the robot's place
 * @param asleep whether the robot neither receives nor sends until it is woken
 * @param batteryPercent the battery's charge
 * @param charging whether the dock charges it
 * @param baud the rate of the robot's port
 * @since 0.1
 */
public record RobotState(
        long timeMillis,
        RobotActivity activity,
        OiMode oiMode,
        Pose pose,
        double leftMmPerS,
        double rightMmPerS,
        Set<Button> pressed,
        boolean streaming,
        Surroundings surroundings,
        boolean asleep,
        int batteryPercent,
        boolean charging,
        int baud) {

    public RobotState {
        pressed = Set.copyOf(pressed);
    }

    /** The x coordinate of the robot's centre. */
    public double xMm() {
        return pose.xMm();
    }

    /** The y coordinate of the robot's centre. */
    public double yMm() {
        return pose.yMm();
    }

    /** The heading from the x axis, counterclockwise, -180 to 180. */
    public double headingDeg() {
        return pose.headingDeg();
    }

    /**
     * One line with these keys in this order: timeMillis, activity, oiMode, xMm, yMm, headingDeg, leftMmPerS,
     * rightMmPerS, pressed, streaming, docked, charging, lifted, asleep, batteryPercent, bumps, cliffs, wheelDrops,
     * baud. Keys may be added at the end. Names of activity, mode, buttons and sensors are in lower case.
     */
    public String toJson() {
        return String.format(
                Locale.ROOT,
                "{\"timeMillis\":%d,\"activity\":%s,\"oiMode\":%s,\"xMm\":%.1f,\"yMm\":%.1f,\"headingDeg\":%.2f,"
                        + "\"leftMmPerS\":%.1f,\"rightMmPerS\":%.1f,\"pressed\":%s,\"streaming\":%b,"
                        + "\"docked\":%b,\"charging\":%b,\"lifted\":%b,\"asleep\":%b,\"batteryPercent\":%d,"
                        + "\"bumps\":%s,\"cliffs\":%s,\"wheelDrops\":%s,\"baud\":%d}",
                timeMillis,
                quoted(activity),
                quoted(oiMode),
                xMm(),
                yMm(),
                headingDeg(),
                leftMmPerS,
                rightMmPerS,
                list(pressed),
                streaming,
                surroundings.docked(),
                charging,
                surroundings.lifted(),
                asleep,
                batteryPercent,
                list(surroundings.bumps()),
                list(surroundings.cliffs()),
                list(surroundings.wheelDrops()),
                baud);
    }

    private static String list(Collection<? extends Enum<?>> values) {
        return values.stream()
                .sorted(Comparator.comparingInt(Enum::ordinal))
                .map(RobotState::quoted)
                .collect(Collectors.joining(",", "[", "]"));
    }

    private static String quoted(Enum<?> value) {
        return '"' + value.name().toLowerCase(Locale.ROOT) + '"';
    }
}
