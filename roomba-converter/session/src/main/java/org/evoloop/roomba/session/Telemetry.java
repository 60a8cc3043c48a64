package org.evoloop.roomba.session;

import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.SensorValues;

/**
 * The contents of one frame of the stream.
 *
 * <p>Threading: immutable.
 *
 * @param frame its number in the session, from 1; frames are 15 ms apart
 * @param values the sensors
 * @param pose the robot's pose from odometry
 * @since 0.1
 */
public record Telemetry(long frame, SensorValues values, OdometryPose pose) {

    /** Whether the robot obeys drive commands. */
    public boolean isUnderControl() {
        return values.mode()
                .filter(mode -> mode == OiMode.SAFE || mode == OiMode.FULL)
                .isPresent();
    }
}
