package org.evoloop.roomba.session;

/**
 * The robot's pose relative to that at the start of the session: x ahead, y to the left.
 *
 * <p>Threading: immutable.
 *
 * @param xMm ahead, in mm
 * @param yMm to the left, in mm
 * @param headingRad counterclockwise from ahead, in radians, not wrapped
 * @since 0.1
 */
public record OdometryPose(double xMm, double yMm, double headingRad) {
    /** The pose at the start of the session. */
    public static final OdometryPose ORIGIN = new OdometryPose(0, 0, 0);

    /**
     * The pose at the point that is {@code distanceMm} away from here in the given direction, facing that direction.
     */
    public OdometryPose beyond(double distanceMm, double bearingRad) {
        double direction = headingRad + bearingRad;
        return new OdometryPose(
                xMm + distanceMm * Math.cos(direction), yMm + distanceMm * Math.sin(direction), direction);
    }

    /** The distance to a point, in mm. */
    public double distanceTo(double otherXMm, double otherYMm) {
        return Math.hypot(otherXMm - xMm, otherYMm - yMm);
    }

    /** The direction of a point from here, counterclockwise from straight ahead, -pi to pi. */
    public double bearingTo(double otherXMm, double otherYMm) {
        return Math.IEEEremainder(Math.atan2(otherYMm - yMm, otherXMm - xMm) - headingRad, 2 * Math.PI);
    }
}
