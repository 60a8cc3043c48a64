package org.evoloop.roomba.move.phase;

import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;

/**
 * What the robot is to do next.
 *
 * <p>Threading: immutable.
 */
public sealed interface Maneuver {
    /** The robot's wheels stand 235 mm apart (specification, packet 20). */
    double HALF_WHEEL_BASE_MM = 117.5;

    /** Slower than this the wheels do not turn evenly. */
    double SLOWEST_MM_PER_S = 40;

    /**
     * What may be touched is touched no faster than 100 mm/s, and nothing tells for sure what is in the way: a free
     * line of sight is thinner than the robot, and a chair's leg fits between two of its light sensors. So the robot
     * never drives faster than three steps of its speed controller, which knows only multiples of 28.5 mm/s
     * (specification, "Drive").
     */
    double FASTEST_MM_PER_S = 85;

    /** About 75 degrees a second. */
    double FASTEST_TURN_MM_PER_S = 150;

    /** So many mm/s for each mm that is left: for the last 0.17 m the robot slows down. */
    double SPEED_PER_MM = 0.5;

    /** So many radians a second for each radian that the goal lies aside. */
    double TURN_PER_RAD = 2;

    /**
     * So many mm/s of each wheel for each radian that is left of a turn on the spot: it slows down for the last 15
     * degrees.
     */
    double TURNING_PER_RAD = 570;

    Drive STAND = new Drive(new DriveDirect(0, 0));

    /** Wheel speeds to drive with. */
    record Drive(DriveDirect wheels) implements Maneuver {}

    /** Stop and tell of the arrival. */
    record Arrive() implements Maneuver {}

    /** Stop for good. */
    record GiveUp(Ending ending) implements Maneuver {}

    /** Towards a goal that lies ahead: slower the nearer, and turning on the way. */
    static Maneuver towards(double remainingMm, double bearingRad) {
        double forward = between(SLOWEST_MM_PER_S, SPEED_PER_MM * remainingMm, FASTEST_MM_PER_S);
        double turning = TURN_PER_RAD * bearingRad * HALF_WHEEL_BASE_MM;
        return drive(forward + turning, forward - turning);
    }

    /** On the spot, counterclockwise if positive. */
    static Maneuver turn(double byRad) {
        double speed = between(SLOWEST_MM_PER_S, TURNING_PER_RAD * Math.abs(byRad), FASTEST_TURN_MM_PER_S);
        double right = Math.copySign(speed, byRad);
        return drive(right, -right);
    }

    /** Straight on; negative is backwards. */
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
