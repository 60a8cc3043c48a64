package org.evoloop.roomba.session;

import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.session.inference.ActivityEstimate.EstimatedActivity;
import org.evoloop.roomba.session.inference.Circumstances;
import org.evoloop.roomba.session.inference.SpotWatch;

/**
 * Is notified of the robot's activity.
 *
 * <p>Threading: called on the thread that receives, {@link #stopped} on any; must be quick. One call at a time, except
 * that a press on which the robot does not act may coincide with a call by another thread.
 *
 * @since 0.1
 */
public interface SessionListener {

    /** A frame was received. Called before the notifications that result from it. */
    default void received(Telemetry telemetry) {}

    /**
     * A button on the robot was pressed.
     *
     * @param robotActs whether the robot acts on it by itself, as it does unless it is under control
     */
    default void pressed(Button button, boolean robotActs) {}

    /** The robot's mode shows the effect of this command, the same object that was sent. */
    default void obeyed(Command command) {}

    /** A spot cleaning has ended. */
    default void spotEnded(SpotWatch.SpotEnd how) {}

    /** The robot was stopped from outside, for the given reason: whatever drove it must stop. */
    default void stopped(String why) {}

    /** The robot's activity was observed; it may be known already, or differ from the estimate. */
    default void seen(EstimatedActivity activity) {}

    /**
     * The robot's circumstances have changed, or are reported again after {@link RoombaSession#reportAgain}: then
     * {@code before} is {@link Circumstances#USUAL}.
     *
     * @param activity the robot's estimated activity
     */
    default void changed(Circumstances before, Circumstances now, EstimatedActivity activity) {}
}
