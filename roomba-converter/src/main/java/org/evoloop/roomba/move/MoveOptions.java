package org.evoloop.roomba.move;

import java.time.Duration;

/**
 * Time limits of Move.
 *
 * <p>Threading: immutable.
 *
 * @param limit if the robot has not arrived after this time, it stops for good
 * @param frameLimit the wheels stop when the newest look, or the robot's newest frame, is older than this
 * @param settle this long after a stop command, pictures show the robot at rest: the wheels need 0.1 s to stop, and a
 *     USB camera's frame arrives about as late
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

    /** Limit 5 min, frame limit 300 ms, settling time 250 ms. */
    public static MoveOptions defaults() {
        return new MoveOptions(Duration.ofMinutes(5), Duration.ofMillis(300), Duration.ofMillis(250));
    }

    /** The same with another limit. */
    public MoveOptions withLimit(Duration other) {
        return new MoveOptions(other, frameLimit, settle);
    }

    /**
     * The options for a simulation that runs {@code pace} times as fast as real time: the computer's own delays stay
     * the same.
     */
    public MoveOptions atPace(double pace) {
        double slower = Math.max(1, pace);
        return new MoveOptions(limit, times(frameLimit, slower), times(settle, slower));
    }

    private static Duration times(Duration duration, double factor) {
        return Duration.ofNanos(Math.round(duration.toNanos() * factor));
    }
}
