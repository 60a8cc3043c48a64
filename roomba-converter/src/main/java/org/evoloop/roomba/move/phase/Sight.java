package org.evoloop.roomba.move.phase;

import java.util.Optional;
import org.evoloop.roomba.session.OdometryPose;

/**
 * What is known of the starting point.
 *
 * <p>Threading: immutable.
 *
 * @param stale whether the newest look is too old to drive by
 * @param frame the newest look's frame
 * @param takenNanos when that frame was taken
 * @param promising whether it shows something that is not believed yet
 * @param goal the believed place of the marker or point, in odometry coordinates; empty if never seen
 * @param goalNanos when it was last seen
 */
public record Sight(
        boolean stale, long frame, long takenNanos, boolean promising, Optional<OdometryPose> goal, long goalNanos) {
    /** How many looks in a row must show the same place before it is believed. */
    public static final int BELIEVED_LOOKS = 3;

    /** The goal, if it was seen at this moment or later. */
    public Optional<OdometryPose> goalSince(long nanos) {
        return goal.filter(seen -> goalNanos - nanos >= 0);
    }
}
