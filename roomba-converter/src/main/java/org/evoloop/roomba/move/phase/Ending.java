package org.evoloop.roomba.move.phase;

import java.util.Optional;
import org.evoloop.roomba.session.inference.ActivityEstimate.EstimatedActivity;

/**
 * Why Move must end before it has arrived.
 *
 * <p>Threading: immutable.
 *
 * @param reason for people; empty while Move may go on
 * @param byPerson whether somebody at the robot has ended it
 * @param work what that person has made the robot do by itself; empty if it stands
 */
public record Ending(String reason, boolean byPerson, Optional<EstimatedActivity> work) {
    /** Move may go on. */
    public static final Ending NONE = new Ending("", false, Optional.empty());

    /** Move cannot go on. */
    public static Ending because(String reason) {
        return new Ending(reason, false, Optional.empty());
    }

    /** Somebody at the robot has ended it. */
    public static Ending byPerson(String reason, Optional<EstimatedActivity> work) {
        return new Ending(reason, true, work);
    }

    /** Whether Move must end now. */
    public boolean isDue() {
        return !reason.isEmpty();
    }
}
