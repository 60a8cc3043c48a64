package org.evoloop.roomba;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.evoloop.roomba.move.Move;
import org.evoloop.roomba.session.inference.ActivityEstimate.EstimatedActivity;
import org.evoloop.roomba.session.inference.Circumstances;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/**
 * The names shared by the robot's models and this program (paper, section VI.A). A model need not have all of them: an
 * activity without a state counts as the most similar state.
 */
final class RobotEvents {
    static final String CLEAN = "Clean";
    static final String SPOT = "Spot";
    static final String DOCK = "Dock";
    static final String MAX = "Max";
    static final String POWER = "Power";

    /** The robot drives backwards off its dock; no button does this. */
    static final String UNDOCK = "Undock";

    static final String END_SPOT = "endSpot";
    static final String END_CLEAN = "endClean";
    static final String END_DOCK = "endDock";

    /** The robot stops cleaning and looks for its dock because its battery is low. */
    static final String SEEK_DOCK = "seekDock";

    static final String DOCKED = "docked";
    static final String UNDOCKED = "undocked";
    static final String CHARGED = "charged";
    static final String CHARGING = "charging";
    static final String ASLEEP = "asleep";
    static final String AWAKE = "awake";
    static final String ERROR = "error";
    static final String RECOVERED = "recovered";
    static final String TIMEOUT = "timeout";
    static final String QUIET_OVER = "quietOver";
    static final String LOW_BATTERY = "lowBattery";

    /** An event of a controller: cleaning is due by the owner's timetable. */
    static final String SCHEDULE = "schedule";

    /** The events that the robot's buttons and commands can cause. */
    static final List<String> COMMANDS = List.of(CLEAN, SPOT, DOCK, MAX, POWER, UNDOCK);

    /** What the robot does by itself. */
    static final List<String> FACTS = List.of(
            CLEAN, SPOT, DOCK, END_SPOT, END_CLEAN, END_DOCK, SEEK_DOCK, DOCKED, UNDOCKED, CHARGED, CHARGING, ASLEEP,
            AWAKE, ERROR, RECOVERED);

    /** Events raised by this program's functions and timetable, not by a controller or the robot. */
    private static final Set<String> RAISED = Set.of(Move.ARRIVED, TIMEOUT, QUIET_OVER, LOW_BATTERY, SCHEDULE);

    /** The robot is in standby: its light is off; CLEAN switches it on. */
    static final String STATE_OFF = "Off";

    /** The robot is on and idle. */
    static final String STATE_ON = "On";

    static final String STATE_CLEAN = "Clean";
    static final String STATE_SPOT = "Spot";
    static final String STATE_DOCK = "Dock";
    static final String STATE_ASLEEP = "Asleep";
    static final String STATE_ERROR = "Error";
    static final String STATE_CHARGING = "Charging";
    static final String STATE_CHARGED = "Charged";

    /** All states that its model may have. */
    static final List<String> STATES = List.of(
            STATE_OFF,
            STATE_ON,
            STATE_CLEAN,
            STATE_SPOT,
            STATE_DOCK,
            MAX,
            STATE_ASLEEP,
            STATE_ERROR,
            STATE_CHARGING,
            STATE_CHARGED);

    private RobotEvents() {}

    /** Whether this event is pressed or requested. */
    static boolean isPress(Event event) {
        boolean byDevice = FACTS.contains(event.name()) && !COMMANDS.contains(event.name());
        return !byDevice
                && !RAISED.contains(event.name())
                && event.timeTrigger().isEmpty();
    }

    /** The state of the robot's model for this activity; empty if there is none. */
    static Optional<String> stateName(StateMachine original, EstimatedActivity activity, Circumstances circumstances) {
        return candidates(activity, circumstances).stream()
                .filter(name -> original.hasState(new State(name)))
                .findFirst();
    }

    /** The state for this activity of a robot that is awake, on the floor, and without trouble. */
    static Optional<String> stateName(StateMachine original, EstimatedActivity activity) {
        return stateName(original, activity, Circumstances.USUAL);
    }

    private static List<String> candidates(EstimatedActivity activity, Circumstances circumstances) {
        String idle = activity == EstimatedActivity.STANDBY ? STATE_OFF : STATE_ON;
        if (circumstances.asleep()) {
            return List.of(STATE_ASLEEP, idle);
        }
        if (circumstances.inTrouble() && activity != EstimatedActivity.STANDBY) {
            return activity.isWork() ? List.of(STATE_ERROR, working(activity)) : List.of(STATE_ERROR, idle);
        }
        if (isDocked(activity, circumstances)) {
            return List.of(circumstances.filling() ? STATE_CHARGING : STATE_CHARGED, STATE_CHARGING, idle);
        }
        return activity == EstimatedActivity.MAX
                ? List.of(MAX, STATE_CLEAN)
                : List.of(activity.isWork() ? working(activity) : idle);
    }

    /**
     * Whether the robot is on its dock to stay. One that begins to work there still shows the dock until it has left it.
     */
    static boolean isDocked(EstimatedActivity activity, Circumstances circumstances) {
        return circumstances.docked() && (!activity.isWork() || activity == EstimatedActivity.DOCK);
    }

    private static String working(EstimatedActivity activity) {
        return switch (activity) {
            case SPOT -> STATE_SPOT;
            case DOCK -> STATE_DOCK;
            default -> STATE_CLEAN;
        };
    }

    /** The activity in this state of its model. */
    static EstimatedActivity activity(State state) {
        return switch (state.name()) {
            case STATE_OFF -> EstimatedActivity.STANDBY;
            case STATE_CLEAN -> EstimatedActivity.CLEAN;
            case MAX -> EstimatedActivity.MAX;
            case STATE_SPOT -> EstimatedActivity.SPOT;
            case STATE_DOCK -> EstimatedActivity.DOCK;
            default -> EstimatedActivity.ON;
        };
    }
}
