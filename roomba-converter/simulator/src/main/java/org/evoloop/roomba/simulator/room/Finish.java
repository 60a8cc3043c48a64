package org.evoloop.roomba.simulator.room;

import java.util.OptionalDouble;
import java.util.OptionalInt;

/**
 * How a wall or a piece of furniture looks; whoever draws it chooses what is not told.
 *
 * @param rgb its colour as 0xRRGGBB
 * @param heightMm above the floor, {@value #LOWEST_MM} to {@value #HIGHEST_MM}
 * @since 0.1
 */
public record Finish(OptionalInt rgb, OptionalDouble heightMm) {
    /** Nothing is told. */
    public static final Finish ANY = new Finish(OptionalInt.empty(), OptionalDouble.empty());

    /** A robot's camera is never higher, and so never looks onto the top of anything. */
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
