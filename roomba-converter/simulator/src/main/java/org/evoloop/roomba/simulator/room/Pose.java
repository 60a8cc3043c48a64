package org.evoloop.roomba.simulator.room;

import java.util.Locale;

/**
 * The position of the robot's centre and its heading. Without a room the robot starts at the origin, heading along x; y
 * is to its left.
 *
 * @param headingRad from the x axis, counterclockwise, -pi to pi
 * @since 0.1
 */
public record Pose(double xMm, double yMm, double headingRad) {
    /** The distance between the wheels' contact points, as measured by iRobot. */
    public static final double WHEEL_BASE_MM = 235.0;

    private static final double STRAIGHT_RAD = 1e-12;

    /** At the origin, heading along the x axis. */
    public static final Pose ORIGIN = new Pose(0, 0, 0);

    public Pose {
        headingRad = Math.IEEEremainder(headingRad, 2 * Math.PI);
    }

    /** The pose after both wheels have rolled these distances at steady speeds: an exact arc of a circle. */
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

    /** The position of the robot's centre. */
    public Point center() {
        return new Point(xMm, yMm);
    }

    /** The same heading at another position. */
    public Pose at(Point center) {
        return new Pose(center.xMm(), center.yMm(), headingRad);
    }

    /** The point this far ahead of the centre, and this far to the left of that. */
    public Point ahead(double forwardMm, double leftMm) {
        double cos = Math.cos(headingRad);
        double sin = Math.sin(headingRad);
        return new Point(xMm + forwardMm * cos - leftMm * sin, yMm + forwardMm * sin + leftMm * cos);
    }

    /** The position of a point relative to the robot, ahead (x) and to the left (y); the inverse of {@link #ahead}. */
    public Point seen(Point point) {
        double cos = Math.cos(headingRad);
        double sin = Math.sin(headingRad);
        Point away = point.minus(center());
        return new Point(away.xMm() * cos + away.yMm() * sin, away.yMm() * cos - away.xMm() * sin);
    }

    /** For messages: {@code (1200, -30) mm, 90 degrees}. */
    public String describe() {
        return String.format(Locale.ROOT, "(%.0f, %.0f) mm, %.0f degrees", xMm, yMm, headingDeg());
    }

    /** The distance to a point. */
    public double distanceMmTo(Point point) {
        return distanceMmTo(point.xMm(), point.yMm());
    }

    /** The distance to a point. */
    public double distanceMmTo(double otherXMm, double otherYMm) {
        return Math.hypot(otherXMm - xMm, otherYMm - yMm);
    }

    /** How far the robot must turn to face a point, counterclockwise, -pi to pi. */
    public double bearingRadTo(double otherXMm, double otherYMm) {
        return Math.IEEEremainder(Math.atan2(otherYMm - yMm, otherXMm - xMm) - headingRad, 2 * Math.PI);
    }
}
