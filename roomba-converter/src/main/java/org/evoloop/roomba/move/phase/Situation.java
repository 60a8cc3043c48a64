package org.evoloop.roomba.move.phase;

import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.session.OdometryPose;
import org.evoloop.roomba.session.Telemetry;

/**
 * Where the robot is and what stands in its way, as Move understands it.
 *
 * <p>Threading: immutable.
 *
 * @param nanos the moment
 * @param pose where the robot is by its wheels
 * @param obeys whether the robot does; if it does not, it may again within moments
 * @param obstacle what ends a way forward
 * @param edge whether that is a cliff: near one the robot may not even turn
 * @param near whether the light bumper sees something straight ahead
 * @param sight what is known of the starting point
 * @param end why Move must end now, if it must
 */
public record Situation(
        long nanos,
        OdometryPose pose,
        boolean obeys,
        Obstacle obstacle,
        boolean edge,
        boolean near,
        Sight sight,
        Ending end) {

    /** Of the light bumper's sensors those to the left and right of the middle. */
    private static final int AHEAD_BITS = 0b1100;

    /** Where the robot feels an obstacle. */
    public enum Obstacle {
        NONE,
        LEFT,
        RIGHT,
        /** On both sides, or on none in particular. */
        AHEAD;

        /** Of bumper, cliff sensors and the sensor for virtual walls (packets 7, 9 to 13). */
        static Obstacle in(SensorValues values) {
            boolean left = values.bumpLeft()
                    || values.value(Packet.CLIFF_LEFT) != 0
                    || values.value(Packet.CLIFF_FRONT_LEFT) != 0;
            boolean right = values.bumpRight()
                    || values.value(Packet.CLIFF_RIGHT) != 0
                    || values.value(Packet.CLIFF_FRONT_RIGHT) != 0;
            if ((left && right) || values.value(Packet.VIRTUAL_WALL) != 0) {
                return AHEAD;
            }
            return left ? LEFT : right ? RIGHT : NONE;
        }
    }

    /** What this frame of the robot means at this moment, with what is known of the starting point. */
    public static Situation of(long nanos, Telemetry telemetry, Sight sight, Ending end) {
        SensorValues values = telemetry.values();
        return new Situation(
                nanos,
                telemetry.pose(),
                telemetry.isUnderControl(),
                Obstacle.in(values),
                values.anyCliff(),
                (values.value(Packet.LIGHT_BUMPER) & AHEAD_BITS) != 0,
                sight,
                end);
    }

    /** How far the robot must turn to look at a place, counterclockwise, -pi to pi. */
    double bearingTo(OdometryPose place) {
        return pose.bearingTo(place.xMm(), place.yMm());
    }

    double distanceTo(OdometryPose place) {
        return pose.distanceTo(place.xMm(), place.yMm());
    }
}
