package org.evoloop.roomba.move.phase;

import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.session.OdometryPose;
import org.evoloop.roomba.session.Telemetry;

/**
 * Where the robot is and what is in its way, as Move understands it.
 *
 * <p>Threading: immutable.
 *
 * @param nanos the time of the situation
 * @param pose where the robot is, by odometry
 * @param obeys whether the robot obeys; if not, it may obey again within moments
 * @param obstacle what blocks the way forward
 * @param edge whether that is a cliff: near one the robot must not even turn
 * @param near whether the light bumper detects something straight ahead
 * @param sight what is known of the starting point
 * @param end why Move must end now, or {@link Ending#NONE}
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

    /** The light bumper's two sensors left and right of the middle. */
    private static final int AHEAD_BITS = 0b1100;

    /** On which side the robot detects an obstacle. */
    public enum Obstacle {
        NONE,
        LEFT,
        RIGHT,
        /** On both sides, or side unknown. */
        AHEAD;

        /** Reads bumper, cliff sensors and the virtual-wall sensor (packets 7, 9 to 13). */
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

    /** The situation that this frame shows, given what is known of the starting point. */
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

    /** The same robot later, when it is silent: nobody knows where it is now and whether it obeys. */
    public Situation unheard(long laterNanos) {
        return new Situation(laterNanos, pose, false, obstacle, edge, near, sight, Ending.NONE);
    }

    /** How far the robot must turn to face a place, counterclockwise, -pi to pi. */
    double bearingTo(OdometryPose place) {
        return pose.bearingTo(place.xMm(), place.yMm());
    }

    double distanceTo(OdometryPose place) {
        return pose.distanceTo(place.xMm(), place.yMm());
    }
}
