package org.evoloop.roomba.simulator.room;

import java.util.OptionalDouble;
import java.util.OptionalInt;

/**
 * The look of a wall or a piece of furniture; unspecified values are chosen when it is drawn.
 *
 * @param rgb its colour as 0xRRGGBB
 * @param heightMm its height above the floor, {@value #LOWEST_MM} to {@value #HIGHEST_MM}
 * @since 0.1
 */
public record Finish(OptionalInt rgb, OptionalDouble heightMm) {
    /** Nothing is specified. */
    public static final Finish ANY = new Finish(OptionalInt.empty(), OptionalDouble.empty());

    /** A robot's camera is never higher than this, so the top of an object is never visible. */
    public static final double LOWEST_MM = 200;

    private static final double HIGHEST_MM = 5_000;

    public Finish {
        if (rgb.isPresent() && rgb.getAsInt() >>> 24 != 0) {
            throw new IllegalArgumentException(
                    "the color is 0x" + Integer.toHexString(rgb.getAsInt()) + "; allowed is 0x000000 to 0xffffff");
        }
        if (heightMm.isPresent() && !(heightMm.getAsDouble() >= LOWEST_MM && heightMm.getAsDouble() <= HIGHEST_MM)) {
            throw new IllegalArgumentException("the height is " + heightMm.getAsDouble() + " mm; allowed is "
                    + (int) LOWEST_MM + " to " + (int) HIGHEST_MM);
        }
    }
}
