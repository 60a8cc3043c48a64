package org.evoloop.roomba.simulator.robot;

import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.OiMode;

/**
 * The truth about a simulated robot at one moment, whatever its sensors tell.
 *
 * @param timeMillis since the robot was made
 * @param xMm of the robot's centre; it begins at 0, and x is where it looked then
 * @param yMm to the left of x
 * @param headingDeg from x, counterclockwise, -180 to 180
 * @param leftMmPerS how fast the left wheel turns
 * @param rightMmPerS how fast the right wheel turns
 * @param pressed the buttons held down
 * @param streaming whether frames are being sent
 */
public record RobotState(
        long timeMillis,
        Activity activity,
        OiMode oiMode,
        double xMm,
        double yMm,
        double headingDeg,
        double leftMmPerS,
        double rightMmPerS,
        Set<Button> pressed,
        boolean streaming) {

    public RobotState {
        pressed = Set.copyOf(pressed);
    }

    /** One line, its keys the components' names in their order; names of activity, mode and buttons in lower case. */
    public String toJson() {
        String buttons = pressed.stream().sorted().map(RobotState::quoted).collect(Collectors.joining(",", "[", "]"));
        return String.format(
                Locale.ROOT,
                "{\"timeMillis\":%d,\"activity\":%s,\"oiMode\":%s,\"xMm\":%.1f,\"yMm\":%.1f,\"headingDeg\":%.2f,"
                        + "\"leftMmPerS\":%.1f,\"rightMmPerS\":%.1f,\"pressed\":%s,\"streaming\":%b}",
                timeMillis,
                quoted(activity),
                quoted(oiMode),
                xMm,
                yMm,
                headingDeg,
                leftMmPerS,
                rightMmPerS,
                buttons,
                streaming);
    }

    private static String quoted(Enum<?> value) {
        return '"' + value.name().toLowerCase(Locale.ROOT) + '"';
    }
}
