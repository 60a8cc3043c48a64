package org.evoloop.roomba.move.phase;

import java.util.Optional;
import org.evoloop.roomba.session.OdometryPose;

/**
 * What is known of the starting point.
 *
 * <p>Threading: immutable.
 *
 * @param stale whether the newest look is too old to drive by
 * @param frame of the newest look
 * @param takenNanos when it was taken
 * @param promising whether it shows something that is not believed yet
 * @param goal where that was believed to be which the sensor looks for, in the coordinates of the robot's wheels; empty
 *     if it was never seen
 * @param goalNanos when that was seen last
 */
public record Sight(
        boolean stale, long frame, long takenNanos, boolean promising, Optional<OdometryPose> goal, long goalNanos) {
    /** So many looks in a row must show the same place until it is believed. */
    public static final int BELIEVED_LOOKS = 3;

    /** The goal, if it was seen at this moment or later. */
    public Optional<OdometryPose> goalSince(long nanos) {
        return goal.filter(seen -> goalNanos - nanos >= 0);
    }
}
