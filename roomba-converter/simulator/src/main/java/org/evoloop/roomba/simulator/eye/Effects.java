package org.evoloop.roomba.simulator.eye;

import java.util.ArrayList;
import java.util.List;

/**
 * The effects of lens, sensor and light on a picture.
 *
 * @param blurPx the standard deviation of the lens blur, 0 to 5
 * @param noiseLevels the standard deviation of each value's noise, in levels of 255, 0 to 64
 * @param motionPx constant horizontal motion blur, 0 to {@value #LONGEST_SMEAR_PX}
 * @param exposureMillis the exposure time; a turning robot adds motion blur by the angle turned during this time, up to
 *     {@value #LONGEST_SMEAR_PX} pixels; 0 to 100
 * @param lightLeft the brightness factor at the picture's left edge, 0 to 2; 1 is neutral
 * @param lightRight the brightness factor at its right edge, 0 to 2
 * @since 0.1
 */
public record Effects(
        double blurPx,
        double noiseLevels,
        double motionPx,
        double exposureMillis,
        double lightLeft,
        double lightRight) {
    /** No effects. */
    public static final Effects CLEAN = new Effects(0, 0, 0, 0, 1, 1);

    /** A cheap camera in a room with one window. */
    public static final Effects TYPICAL = new Effects(1.1, 8, 0, 0, 0.4, 1.1);

    /** The same camera at dusk, on a robot that never stops. */
    public static final Effects HARD = new Effects(1.5, 14, 7, 0, 0.2, 1.1);

    static final int LONGEST_SMEAR_PX = 60;

    /** Rejects invalid values, with all problems in one message. */
    public Effects {
        List<String> problems = new ArrayList<>();
        require("lens blur in pixels", blurPx, 5, problems);
        require("noise in gray levels", noiseLevels, 64, problems);
        require("motion blur in pixels", motionPx, LONGEST_SMEAR_PX, problems);
        require("exposure in ms", exposureMillis, 100, problems);
        require("light at the left", lightLeft, 2, problems);
        require("light at the right", lightRight, 2, problems);
        if (!problems.isEmpty()) {
            throw new IllegalArgumentException(String.join("\n", problems));
        }
    }

    private static void require(String name, double value, int most, List<String> problems) {
        if (!(value >= 0 && value <= most)) {
            problems.add(name + " is " + value + "; allowed is 0 to " + most);
        }
    }

    /**
     * The effects with this name: clean, typical or hard.
     *
     * @throws IllegalArgumentException for any other name
     */
    public static Effects named(String name) {
        return switch (name) {
            case "clean" -> CLEAN;
            case "typical" -> TYPICAL;
            case "hard" -> HARD;
            default ->
                throw new IllegalArgumentException(
                        "camera quality is '" + name + "'; there are clean, typical and hard");
        };
    }

    /** A copy with another exposure time. */
    public Effects withExposureMillis(double millis) {
        return new Effects(blurPx, noiseLevels, motionPx, millis, lightLeft, lightRight);
    }
}
