package org.evoloop.roomba.session;

/**
 * Where the robot is, seen from where it stood when the session began: x ahead, y to the left.
 *
 * <p>Threading: immutable.
 *
 * @param xMm ahead, in mm
 * @param yMm to the left, in mm
 * @param headingRad counterclockwise from ahead, in radians, not wrapped
 * @since 0.1
 */
public record OdometryPose(double xMm, double yMm, double headingRad) {
    /** Where the session began. */
    public static final OdometryPose ORIGIN = new OdometryPose(0, 0, 0);

    /** The pose in which a robot that stands here sees what lies {@code distanceMm} away: looking at it, and there. */
    public OdometryPose beyond(double distanceMm, double bearingRad) {
        double direction = headingRad + bearingRad;
        return new OdometryPose(
                xMm + distanceMm * Math.cos(direction), yMm + distanceMm * Math.sin(direction), direction);
    }

    /** How far it is to a point, in mm. */
    public double distanceTo(double otherXMm, double otherYMm) {
        return Math.hypot(otherXMm - xMm, otherYMm - yMm);
    }

    /** Where a point lies as seen from here, counterclockwise from straight ahead, -pi to pi. */
    public double bearingTo(double otherXMm, double otherYMm) {
        return Math.IEEEremainder(Math.atan2(otherYMm - yMm, otherXMm - xMm) - headingRad, 2 * Math.PI);
    }
}
