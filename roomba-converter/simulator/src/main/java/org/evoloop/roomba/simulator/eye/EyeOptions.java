package org.evoloop.roomba.simulator.eye;

import java.util.ArrayList;
import java.util.List;

/**
 * What can be chosen about the camera. It looks straight ahead and level from above the robot's centre.
 *
 * @param widthPx {@value #SMALLEST_PX} to {@value #LARGEST_PX}
 * @param heightPx likewise
 * @param fieldOfViewDeg from the picture's left edge to its right, 20 to 120
 * @param heightMm of the lens above the floor, 50 to 200
 * @param seed chooses the room's decoration where the room does not tell, and the noise
 * @since 0.1
 */
public record EyeOptions(
        int widthPx, int heightPx, double fieldOfViewDeg, double heightMm, long seed, Effects effects) {
    private static final int SMALLEST_PX = 16;
    private static final int LARGEST_PX = 1_920;

    /** Refuses with all that is wrong in one message. */
    public EyeOptions {
        List<String> problems = new ArrayList<>();
        require("picture width in pixels", widthPx, SMALLEST_PX, LARGEST_PX, problems);
        require("picture height in pixels", heightPx, SMALLEST_PX, LARGEST_PX, problems);
        require("field of view in degrees", fieldOfViewDeg, 20, 120, problems);
        require("camera height in mm", heightMm, 50, 200, problems);
        if (!problems.isEmpty()) {
            throw new IllegalArgumentException(String.join("\n", problems));
        }
    }

    private static void require(String name, double value, int least, int most, List<String> problems) {
        if (!(value >= least && value <= most)) {
            problems.add(name + " is " + (value == Math.rint(value) ? Long.toString((long) value) : value)
                    + "; allowed is " + least + " to " + most);
        }
    }

    /** 640 by 480 pixels over 60 degrees from 150 mm above the floor, with the effects of a typical camera. */
    public static EyeOptions defaults() {
        return new EyeOptions(640, 480, 60, 150, 1, Effects.TYPICAL);
    }

    /** The same, with pictures of another size in pixels. */
    public EyeOptions withSize(int width, int height) {
        return new EyeOptions(width, height, fieldOfViewDeg, heightMm, seed, effects);
    }

    /** The same, with another horizontal angle of view. */
    public EyeOptions withFieldOfViewDeg(double degrees) {
        return new EyeOptions(widthPx, heightPx, degrees, heightMm, seed, effects);
    }

    /** The same, with other decoration and noise. */
    public EyeOptions withSeed(long number) {
        return new EyeOptions(widthPx, heightPx, fieldOfViewDeg, heightMm, number, effects);
    }

    /** The same, with other effects. */
    public EyeOptions withEffects(Effects others) {
        return new EyeOptions(widthPx, heightPx, fieldOfViewDeg, heightMm, seed, others);
    }

    /** The focal length in pixels, which are square. */
    public double focalPx() {
        return widthPx / 2.0 / Math.tan(Math.toRadians(fieldOfViewDeg) / 2);
    }
}
