package org.evoloop.roomba.simulator.body;

/**
 * Where the robot's centre is and where it looks. The robot begins at the origin and looks along x; y is to its left.
 *
 * @param headingRad from the x axis, counterclockwise, -pi to pi
 */
public record Pose(double xMm, double yMm, double headingRad) {
    /** Between the points where the wheels touch the floor, as measured by iRobot. */
    public static final double WHEEL_BASE_MM = 235.0;

    private static final double STRAIGHT_RAD = 1e-12;

    public static final Pose ORIGIN = new Pose(0, 0, 0);

    public Pose {
        headingRad = Math.IEEEremainder(headingRad, 2 * Math.PI);
    }

    /** The pose after both wheels have rolled so far at steady speeds: the exact arc of a circle. */
    public Pose rolled(double leftMm, double rightMm) {
        double forwardMm = (leftMm + rightMm) / 2;
        double turnRad = (rightMm - leftMm) / WHEEL_BASE_MM;
        if (Math.abs(turnRad) < STRAIGHT_RAD) {
            return new Pose(xMm + forwardMm * Math.cos(headingRad), yMm + forwardMm * Math.sin(headingRad), headingRad);
        }
        double radiusMm = forwardMm / turnRad;
        double laterRad = headingRad + turnRad;
        return new Pose(
                xMm + radiusMm * (Math.sin(laterRad) - Math.sin(headingRad)),
                yMm - radiusMm * (Math.cos(laterRad) - Math.cos(headingRad)),
                laterRad);
    }

    /** From the x axis, counterclockwise, -180 to 180. */
    public double headingDeg() {
        return Math.toDegrees(headingRad);
    }

    /** How far away a point is. */
    public double distanceMmTo(double otherXMm, double otherYMm) {
        return Math.hypot(otherXMm - xMm, otherYMm - yMm);
    }

    /** How far the robot must turn to look at a point, counterclockwise, -pi to pi. */
    public double bearingRadTo(double otherXMm, double otherYMm) {
        return Math.IEEEremainder(Math.atan2(otherYMm - yMm, otherXMm - xMm) - headingRad, 2 * Math.PI);
    }
}
