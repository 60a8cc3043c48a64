package org.evoloop.roomba.move;

import java.time.Duration;

/**
 * How patient Move is.
 *
 * <p>Threading: immutable.
 *
 * @param limit after so long without an arrival the robot stops for good
 * @param frameLimit the wheels stop when the newest look is older than this
 * @param settle so long after the robot was told to stop, what the camera shows was taken at rest: the wheels need 0.1
 *     s, and a frame of a USB camera reaches the program about as late
 */
public record MoveOptions(Duration limit, Duration frameLimit, Duration settle) {

    /** @throws IllegalArgumentException if a value is not positive */
    public MoveOptions {
        require("limit", limit);
        require("frameLimit", frameLimit);
        require("settle", settle);
    }

    private static void require(String name, Duration value) {
        if (value.isNegative() || value.isZero()) {
            throw new IllegalArgumentException(name + " is " + value + ", allowed is more than 0");
        }
    }

    /** Five minutes in all, 300 ms for a frame, 250 ms to come to rest. */
    public static MoveOptions defaults() {
        return new MoveOptions(Duration.ofMinutes(5), Duration.ofMillis(300), Duration.ofMillis(250));
    }

    /** The same with another limit. */
    public MoveOptions withLimit(Duration other) {
        return new MoveOptions(other, frameLimit, settle);
    }

    /** The same for a simulation that runs so many times as fast: its computer does not. */
    public MoveOptions atPace(double pace) {
        double slower = Math.max(1, pace);
        return new MoveOptions(limit, times(frameLimit, slower), times(settle, slower));
    }

    private static Duration times(Duration duration, double factor) {
        return Duration.ofNanos(Math.round(duration.toNanos() * factor));
    }
}
