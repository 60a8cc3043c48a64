package org.evoloop.roomba.simulator.eye;

import java.util.ArrayList;
import java.util.List;

/**
 * The camera's options. It is mounted above the robot's centre and looks straight ahead and level. Values out of range
 * are rejected, with all problems in one message.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class EyeOptions {
    private static final int SMALLEST_PX = 16;
    private static final int LARGEST_PX = 1_920;

    private final int widthPx;
    private final int heightPx;
    private final double fieldOfViewDeg;
    private final double heightMm;
    private final long seed;
    private final Effects effects;

    private EyeOptions(int widthPx, int heightPx, double fieldOfViewDeg, double heightMm, long seed, Effects effects) {
        List<String> problems = new ArrayList<>();
        require("picture width in pixels", widthPx, SMALLEST_PX, LARGEST_PX, problems);
        require("picture height in pixels", heightPx, SMALLEST_PX, LARGEST_PX, problems);
        require("field of view in degrees", fieldOfViewDeg, 20, 120, problems);
        require("camera height in mm", heightMm, 50, 200, problems);
        if (!problems.isEmpty()) {
            throw new IllegalArgumentException(String.join("\n", problems));
        }
        this.widthPx = widthPx;
        this.heightPx = heightPx;
        this.fieldOfViewDeg = fieldOfViewDeg;
        this.heightMm = heightMm;
        this.seed = seed;
        this.effects = effects;
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

    /** A copy with pictures of another size, in pixels. */
    public EyeOptions withSize(int width, int height) {
        return new EyeOptions(width, height, fieldOfViewDeg, heightMm, seed, effects);
    }

    /** A copy with another field of view, in degrees. */
    public EyeOptions withFieldOfViewDeg(double degrees) {
        return new EyeOptions(widthPx, heightPx, degrees, heightMm, seed, effects);
    }

    /** A copy with the lens at another height above the floor, in mm. */
    public EyeOptions withHeightMm(double height) {
        return new EyeOptions(widthPx, heightPx, fieldOfViewDeg, height, seed, effects);
    }

    /** A copy with another decoration and other noise. */
    public EyeOptions withSeed(long number) {
        return new EyeOptions(widthPx, heightPx, fieldOfViewDeg, heightMm, number, effects);
    }

    /** A copy with other effects of lens and sensor. */
    public EyeOptions withEffects(Effects others) {
        return new EyeOptions(widthPx, heightPx, fieldOfViewDeg, heightMm, seed, others);
    }

    /** The focal length in pixels; pixels are square. */
    public double focalPx() {
        return widthPx / 2.0 / Math.tan(Math.toRadians(fieldOfViewDeg) / 2);
    }

    /** The width of a picture in pixels, {@value #SMALLEST_PX} to {@value #LARGEST_PX}. */
    public int widthPx() {
        return widthPx;
    }

    /** The height of a picture in pixels, {@value #SMALLEST_PX} to {@value #LARGEST_PX}. */
    public int heightPx() {
        return heightPx;
    }

    /** The horizontal field of view, in degrees, 20 to 120. */
    public double fieldOfViewDeg() {
        return fieldOfViewDeg;
    }

    /** The height of the lens above the floor, in mm, 50 to 200. */
    public double heightMm() {
        return heightMm;
    }

    /** The seed for the noise, and for decoration that the room does not specify. */
    public long seed() {
        return seed;
    }

    /** The effects of lens and sensor. */
    public Effects effects() {
        return effects;
    }
}
