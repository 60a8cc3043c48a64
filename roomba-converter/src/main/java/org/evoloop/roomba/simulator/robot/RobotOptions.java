package org.evoloop.roomba.simulator.robot;

/**
 * What can be chosen about a simulated robot.
 *
 * @param spotDurationMillis how long spot cleaning lasts, {@value #SHORTEST_SPOT_MILLIS} to
 *     {@value #LONGEST_SPOT_MILLIS}; iRobot does not tell how long it is in truth
 */
public record RobotOptions(int spotDurationMillis) {
    /** Less would not suffice to drive half a metre and back. */
    public static final int SHORTEST_SPOT_MILLIS = 8_000;

    public static final int LONGEST_SPOT_MILLIS = 600_000;
    public static final int DEFAULT_SPOT_MILLIS = 45_000;

    public RobotOptions {
        if (spotDurationMillis < SHORTEST_SPOT_MILLIS || spotDurationMillis > LONGEST_SPOT_MILLIS) {
            throw new IllegalArgumentException("spot duration is " + spotDurationMillis + " ms; allowed is "
                    + SHORTEST_SPOT_MILLIS + " to " + LONGEST_SPOT_MILLIS + " ms");
        }
    }

    /** A well-behaved robot. */
    public static RobotOptions defaults() {
        return new RobotOptions(DEFAULT_SPOT_MILLIS);
    }

    public RobotOptions withSpotDurationMillis(int millis) {
        return new RobotOptions(millis);
    }
}
