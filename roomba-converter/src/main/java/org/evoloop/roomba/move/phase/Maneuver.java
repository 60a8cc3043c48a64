package org.evoloop.roomba.move.phase;

import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;

/**
 * What the robot does next.
 *
 * <p>Threading: immutable.
 */
public sealed interface Maneuver {
    /** Half the distance between the wheels, 235 mm (specification, packet 20). */
    double HALF_WHEEL_BASE_MM = 117.5;

    /** Below this speed the wheels do not turn evenly. */
    double SLOWEST_MM_PER_S = 40;

    /**
     * The robot must touch obstacles at 100 mm/s at most, and no sensor detects them all in advance: a free line of
     * sight is thinner than the robot, and a chair's leg fits between two light sensors. So it never drives faster than
     * three steps of its speed controller, which only has multiples of 28.5 mm/s (specification, "Drive").
     */
    double FASTEST_MM_PER_S = 85;

    /** About 75 degrees a second. */
    double FASTEST_TURN_MM_PER_S = 150;

    /** Speed in mm/s per mm of remaining distance: the robot slows down over the last 0.17 m. */
    double SPEED_PER_MM = 0.5;

    /** Turning rate in radians a second per radian of bearing. */
    double TURN_PER_RAD = 2;

    /**
     * Wheel speed in mm/s per remaining radian of a turn on the spot: the robot slows down over the last 15 degrees.
     */
    double TURNING_PER_RAD = 570;

    Drive STAND = new Drive(new DriveDirect(0, 0));

    /** Drive with these wheel speeds. */
    record Drive(DriveDirect wheels) implements Maneuver {}

    /** Stop and report the arrival. */
    record Arrive() implements Maneuver {}

    /** Stop for good. */
    record GiveUp(Ending ending) implements Maneuver {}

    /** Drives towards a goal ahead: slower when nearer, and turning on the way. */
    static Maneuver towards(double remainingMm, double bearingRad) {
        double forward = between(SLOWEST_MM_PER_S, SPEED_PER_MM * remainingMm, FASTEST_MM_PER_S);
        double turning = TURN_PER_RAD * bearingRad * HALF_WHEEL_BASE_MM;
        return drive(forward + turning, forward - turning);
    }

    /** Turns on the spot, counterclockwise if positive. */
    static Maneuver turn(double byRad) {
        double speed = between(SLOWEST_MM_PER_S, TURNING_PER_RAD * Math.abs(byRad), FASTEST_TURN_MM_PER_S);
        double right = Math.copySign(speed, byRad);
        return drive(right, -right);
    }

    /** Drives straight; negative is backwards. */
    static Maneuver straight(double remainingMm) {
        double speed = Math.copySign(
                between(SLOWEST_MM_PER_S, SPEED_PER_MM * Math.abs(remainingMm), FASTEST_MM_PER_S), remainingMm);
        return drive(speed, speed);
    }

    private static double between(double least, double value, double most) {
        return Math.min(most, Math.max(least, value));
    }

    private static Maneuver drive(double rightMmPerS, double leftMmPerS) {
        return new Drive(new DriveDirect((int) Math.round(rightMmPerS), (int) Math.round(leftMmPerS)));
    }
}
