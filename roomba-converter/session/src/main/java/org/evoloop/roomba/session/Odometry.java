package org.evoloop.roomba.session;

import org.evoloop.roomba.oi.SensorValues;
import org.jspecify.annotations.Nullable;

/**
 * Dead reckoning from the wheel encoders (packets 43 and 44): exact arcs between two readings, right across the 16-bit
 * wrap. Distance and angle (packets 19 and 20) are not used, since old firmware reports them wrong.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class Odometry {
    /** Wheel diameter 72.0 mm, 508.8 counts per revolution (specification, packets 43 and 44). */
    static final double MM_PER_COUNT = Math.PI * 72.0 / 508.8;

    /** Distance between the wheels (specification, packet 20). */
    static final double WHEEL_BASE_MM = 235.0;

    private OdometryPose pose = OdometryPose.ORIGIN;
    private @Nullable SensorValues last;

    /** At {@link OdometryPose#ORIGIN}, before any reading. */
    public Odometry() {}

    /** Takes the next reading and returns the robot's pose. */
    public OdometryPose update(SensorValues values) {
        SensorValues earlier = last;
        last = values;
        if (earlier != null) {
            double left =
                    MM_PER_COUNT * SensorValues.encoderDelta(earlier.leftEncoderCounts(), values.leftEncoderCounts());
            double right =
                    MM_PER_COUNT * SensorValues.encoderDelta(earlier.rightEncoderCounts(), values.rightEncoderCounts());
            pose = moved(pose, left, right);
        }
        return pose;
    }

    private static OdometryPose moved(OdometryPose from, double leftMm, double rightMm) {
        double turned = (rightMm - leftMm) / WHEEL_BASE_MM;
        double travelled = (leftMm + rightMm) / 2;
        // The chord of the arc; for small turns sin(x)/x is 1.
        double chord = Math.abs(turned) < 1e-9 ? travelled : 2 * travelled / turned * Math.sin(turned / 2);
        double direction = from.headingRad() + turned / 2;
        return new OdometryPose(
                from.xMm() + chord * Math.cos(direction),
                from.yMm() + chord * Math.sin(direction),
                from.headingRad() + turned);
    }
}
