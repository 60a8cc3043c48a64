package org.evoloop.roomba.move.phase;

import java.util.Optional;
import org.evoloop.roomba.session.inference.ActivityEstimate.EstimatedActivity;

/**
 * Why Move must end before the robot has arrived.
 *
 * <p>Threading: immutable.
 *
 * @param reason a text for people; empty while Move may continue
 * @param byPerson whether somebody at the robot has ended it
 * @param work what that person has made the robot do by itself; empty if it is at rest
 */
public record Ending(String reason, boolean byPerson, Optional<EstimatedActivity> work) {
    /** Move may continue. */
    public static final Ending NONE = new Ending("", false, Optional.empty());

    /** Move cannot continue. */
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
