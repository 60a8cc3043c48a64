package org.evoloop.roomba.session;

import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.session.inference.ActivityEstimate.EstimatedActivity;
import org.evoloop.roomba.session.inference.Circumstances;
import org.evoloop.roomba.session.inference.SpotWatch;

/**
 * Is notified of the robot's activity.
 *
 * <p>Threading: called on the thread that receives, {@link #stopped} on any; one call at a time; must be quick.
 *
 * @since 0.1
 */
public interface SessionListener {

    /** A frame has come. Called before anything that the frame tells. */
    default void received(Telemetry telemetry) {}

    /**
     * A button on the robot was pressed.
     *
     * @param robotActs whether the robot acts on it by itself, as it does unless it is under control
     */
    default void pressed(Button button, boolean robotActs) {}

    /** The robot's mode shows that this command, the very one that was sent, has had its effect. */
    default void obeyed(Command command) {}

    /** A spot cleaning has ended. */
    default void spotEnded(SpotWatch.Ending how) {}

    /** Somebody else has stopped the robot, for the reason given: what drove it is not to go on. */
    default void stopped(String why) {}

    /** The robot does this now, whatever it was taken to do; it may be known already. */
    default void seen(EstimatedActivity activity) {}

    /**
     * The robot's circumstances have changed, or are told again because somebody {@link RoombaSession#tellAgain asked}:
     * then {@code before} is {@link Circumstances#USUAL}.
     *
     * @param activity what the robot is taken to do
     */
    default void changed(Circumstances before, Circumstances now, EstimatedActivity activity) {}
}
