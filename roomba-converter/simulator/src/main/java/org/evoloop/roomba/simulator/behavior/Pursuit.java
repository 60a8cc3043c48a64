package org.evoloop.roomba.simulator.behavior;

import org.evoloop.roomba.simulator.body.Body;
import org.evoloop.roomba.simulator.body.Wheel;
import org.evoloop.roomba.simulator.room.Point;
import org.evoloop.roomba.simulator.room.Pose;

/** Drives towards a point: along an arc that ends there, or after a turn on the spot if it is behind the robot. */
final class Pursuit {
    private static final double ARRIVED_MM = 10;
    private static final double SPIN_MM_PER_S = 200;

    private Pursuit() {}

    /**
     * Sets the wheels.
     *
     * @param withinSeconds when the robot would be there at an even speed; the wheels may not be able to
     */
    static void steer(Body body, Point goal, double withinSeconds) {
        double distanceMm = body.pose().distanceMmTo(goal);
        double bearingRad = body.pose().bearingRadTo(goal.xMm(), goal.yMm());
        if (distanceMm < ARRIVED_MM) {
            body.drive(0, 0);
        } else if (Math.abs(bearingRad) > Math.PI / 2) {
            spin(body, Math.signum(bearingRad));
        } else {
            driveArc(body, distanceMm / withinSeconds, 2 * Math.sin(bearingRad) / distanceMm);
        }
    }

    /** Turns on the spot, counterclockwise if {@code direction} is 1, clockwise if it is -1. */
    static void spin(Body body, double direction) {
        body.drive(direction * SPIN_MM_PER_S, -direction * SPIN_MM_PER_S);
    }

    /** Drives along an arc of this curvature, slower where the outer wheel could not follow. */
    private static void driveArc(Body body, double speedMmPerS, double curvaturePerMm) {
        double difference = curvaturePerMm * Pose.WHEEL_BASE_MM / 2;
        double speed = Math.min(speedMmPerS, Wheel.FASTEST_MM_PER_S / (1 + Math.abs(difference)));
        body.drive(speed * (1 + difference), speed * (1 - difference));
    }
}
