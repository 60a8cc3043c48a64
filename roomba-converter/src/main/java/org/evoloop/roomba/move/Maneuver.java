package org.evoloop.roomba.move;

import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;

/**
 * What to do next on a {@link Course}.
 *
 * <p>Threading: immutable.
 */
sealed interface Maneuver {
    /** The robot's wheels stand 235 mm apart (specification, packet 20). */
    double HALF_WHEEL_BASE_MM = 117.5;

    /** Fast enough to get there, slow enough to stop on a bump. */
    int FASTEST_MM_PER_S = 300;

    /** Slower than this the wheels do not turn evenly. */
    int SLOWEST_MM_PER_S = 40;

    /** Wheel speeds to drive with. */
    record Drive(DriveDirect wheels) implements Maneuver {}

    /** Stop and tell of the arrival. */
    record Arrive() implements Maneuver {}

    /** Stop for good. */
    record GiveUp(String reason) implements Maneuver {}

    /** The maneuver for {@code course}: slower the nearer, and turning towards the point on the way. */
    static Maneuver on(Course course) {
        if (course instanceof Course.Approach approach) {
            double forward = limit(1.5 * approach.distanceMm());
            double turning = 2 * approach.bearingRad() * HALF_WHEEL_BASE_MM;
            return drive(forward + turning, forward - turning);
        }
        if (course instanceof Course.Turn turn) {
            double turning = Math.copySign(limit(150 * Math.abs(turn.bearingRad())), turn.bearingRad());
            return drive(turning, -turning);
        }
        if (course instanceof Course.Lost) {
            return drive(0, 0);
        }
        return course instanceof Course.Arrived
                ? new Arrive()
                : new GiveUp("the robot is not under control any more; was it lifted?");
    }

    private static double limit(double speedMmPerS) {
        return Math.min(FASTEST_MM_PER_S, Math.max(SLOWEST_MM_PER_S, speedMmPerS));
    }

    private static Maneuver drive(double rightMmPerS, double leftMmPerS) {
        return new Drive(new DriveDirect((int) Math.round(rightMmPerS), (int) Math.round(leftMmPerS)));
    }
}
