package org.evoloop.roomba.session;

import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.session.inference.ActivityEstimate;
import org.evoloop.roomba.session.inference.ActivityWatch;
import org.evoloop.roomba.session.inference.ButtonPresses;
import org.evoloop.roomba.session.inference.SpotWatch;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Makes out of frames and commands what the robot does by itself, and tells it: presses of its buttons, the end of a spot
 * cleaning, and what it is seen to do.
 *
 * <p>Threading: not thread-safe.
 */
final class RobotWatch {
    private static final Logger LOG = LoggerFactory.getLogger(RoombaSession.class);

    private final SessionListener listener;
    private final ButtonPresses buttons = new ButtonPresses();
    private final SpotWatch spotWatch = new SpotWatch();
    private final ActivityWatch activityWatch = new ActivityWatch();
    private final ActivityEstimate estimate = new ActivityEstimate();

    RobotWatch(SessionListener listener) {
        this.listener = listener;
    }

    /**
     * Takes the next frame.
     *
     * @param worksAreNews whether a robot at work is worth telling; not if its work is about to be ended
     */
    void update(Telemetry now, boolean worksAreNews) {
        tellPresses(now);
        SensorValues values = now.values();
        SpotWatch.Ending ending = spotWatch.update(values);
        if (ending != null) {
            estimate.seenAtRest();
            listener.spotEnded(ending);
        }
        ActivityWatch.Seen seen = activityWatch.update(values, now.isUnderControl());
        if (seen == ActivityWatch.Seen.AT_REST) {
            estimate.seenAtRest();
            tellActivity();
        } else if (seen == ActivityWatch.Seen.AT_WORK && worksAreNews) {
            estimate.seenAtWork();
            tellActivity();
        }
    }

    private void tellPresses(Telemetry now) {
        for (Button button : buttons.update(now.values().buttons())) {
            boolean robotActs = !now.isUnderControl();
            listener.pressed(button, robotActs);
            if (robotActs) {
                obeyed(button);
            }
        }
    }

    private void obeyed(Button button) {
        estimate.pressed(button);
        // What the motors did before says nothing about what comes of the press.
        activityWatch.forget();
        if (estimate.activity().isWork()) {
            activityWatch.expected();
        }
        if (estimate.activity() == ActivityEstimate.Activity.SPOT) {
            spotWatch.started();
        } else {
            spotWatch.forget();
        }
        tellActivity();
    }

    /** Tells what the robot does, as far as it is one of the things that its model knows. */
    void tellActivity() {
        switch (estimate.activity()) {
            case ON -> listener.seen(SessionListener.Activity.ON);
            case CLEAN -> listener.seen(SessionListener.Activity.CLEAN);
            case SPOT -> listener.seen(SessionListener.Activity.SPOT);
            default -> LOG.debug("the robot is in {}", estimate.activity());
        }
    }

    /** A command has been sent. */
    void commanded(Command command) {
        estimate.commanded(command);
        if (command instanceof Command.Spot || command instanceof Command.Clean) {
            activityWatch.expected();
        }
        if (command instanceof Command.Spot && estimate.activity() == ActivityEstimate.Activity.SPOT) {
            spotWatch.started();
        }
    }

    /** Control has begun: whatever the robot did has ended. */
    void controlled() {
        estimate.controlled();
    }

    /** It is known that the robot does nothing, whatever it was taken to do. */
    void tellOn() {
        listener.seen(SessionListener.Activity.ON);
    }

    /** The robot is out of sight: what was seen of it counts no more. */
    void forget() {
        spotWatch.forget();
        activityWatch.forget();
    }

    /** Whether its motors show that the robot is at work, whatever its mode. */
    boolean isAtWork() {
        return activityWatch.isAtWork();
    }

    /** Whether the robot has been at rest for a while. */
    boolean isAtRest() {
        return activityWatch.restFrames() >= SpotWatch.QUIET_FRAMES;
    }
}
