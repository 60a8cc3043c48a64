package org.evoloop.roomba.simulator.behavior;

import org.evoloop.roomba.simulator.body.Body;
import org.evoloop.roomba.simulator.room.Point;
import org.evoloop.roomba.simulator.room.Pose;

/**
 * A spiral with even distances between its turns, and a robot that runs after a point that moves along it at an even
 * speed. Near the centre the point turns more tightly than a robot can; there the robot cuts the corner.
 *
 * @param start the centre, and where the robot looks as it leaves it
 * @param outwardSeconds how long the point takes to the outermost turn; the longer, the closer the turns
 */
record Spiral(Pose start, double outwardSeconds) {
    private static final double OUTER_RADIUS_MM = 475;
    private static final double POINT_MM_PER_S = 300;

    /** How far the robot keeps behind the point. */
    private static final double BEHIND_SECONDS = 0.4;

    /** Steers after the point on its way out, and along the outermost turn's end when it has come there. */
    void steerOutward(Body body, double elapsedSeconds) {
        double seconds = Math.min(elapsedSeconds + BEHIND_SECONDS, outwardSeconds);
        steerTowards(body, radiusMm(seconds), angleRad(seconds));
    }

    /** Steers after the point that has turned round at the outermost turn and comes back to the centre. */
    void steerInward(Body body, double elapsedSeconds) {
        double secondsLeft = Math.max(0, outwardSeconds - elapsedSeconds - BEHIND_SECONDS);
        steerTowards(body, radiusMm(secondsLeft), 2 * angleRad(outwardSeconds) - angleRad(secondsLeft));
    }

    /** At an even speed the swept area, and with it the radius' square, grows evenly. */
    private double radiusMm(double seconds) {
        return OUTER_RADIUS_MM * Math.sqrt(seconds / outwardSeconds);
    }

    /** The integral of speed by radius. */
    private double angleRad(double seconds) {
        return 2 * POINT_MM_PER_S * Math.sqrt(seconds * outwardSeconds) / OUTER_RADIUS_MM;
    }

    private void steerTowards(Body body, double radiusMm, double angleRad) {
        double directionRad = start.headingRad() + angleRad;
        Point goal = new Point(
                start.xMm() + radiusMm * Math.cos(directionRad), start.yMm() + radiusMm * Math.sin(directionRad));
        Pursuit.steer(body, goal, BEHIND_SECONDS);
    }
}
