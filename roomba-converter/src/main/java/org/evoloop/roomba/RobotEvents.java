package org.evoloop.roomba;

import java.util.Optional;
import org.evoloop.roomba.session.SessionListener.SeenActivity;
import org.evoloop.roomba.session.inference.ActivityEstimate;
import org.evoloop.statemachine.State;

/** The names that the models of the cleaning robot and this program have in common (paper, section VI.A). */
final class RobotEvents {
    static final String CLEAN = "Clean";
    static final String SPOT = "Spot";
    static final String END_SPOT = "endSpot";
    static final String TIMEOUT = "timeout";

    /** The robot stands by: its light is off, and CLEAN switches it on. */
    static final String STATE_OFF = "Off";

    /** The robot is on and does nothing. */
    static final String STATE_ON = "On";

    static final String STATE_CLEAN = "Clean";
    static final String STATE_SPOT = "Spot";

    private RobotEvents() {}

    /** The state of the robot's model in which it does this; empty if that knows none. */
    static Optional<String> stateName(ActivityEstimate.EstimatedActivity activity) {
        return switch (activity) {
            case STANDBY -> Optional.of(STATE_OFF);
            case ON -> Optional.of(STATE_ON);
            case CLEAN -> Optional.of(STATE_CLEAN);
            case SPOT -> Optional.of(STATE_SPOT);
            case DOCK -> Optional.empty();
        };
    }

    /** What it does in this state of its model. */
    static ActivityEstimate.EstimatedActivity activity(State state) {
        for (ActivityEstimate.EstimatedActivity activity : ActivityEstimate.EstimatedActivity.values()) {
            if (stateName(activity).filter(state.name()::equals).isPresent()) {
                return activity;
            }
        }
        throw new IllegalArgumentException("the robot has no state " + state);
    }

    /** The state of the robot's model in which it does this. */
    static State state(SeenActivity activity) {
        return new State(
                switch (activity) {
                    case ON -> STATE_ON;
                    case CLEAN -> STATE_CLEAN;
                    case SPOT -> STATE_SPOT;
                });
    }
}
