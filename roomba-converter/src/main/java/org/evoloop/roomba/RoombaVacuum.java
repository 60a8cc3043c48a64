package org.evoloop.roomba;

import static java.util.Objects.requireNonNull;

import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.mqtt.HomeAssistant;
import org.evoloop.mqtt.Vacuum;
import org.evoloop.roomba.move.Move;
import org.evoloop.roomba.oi.ActuatorCommand;
import org.evoloop.roomba.oi.ActuatorCommand.Song.Note;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.Telemetry;
import org.evoloop.roomba.session.inference.ActivityEstimate.EstimatedActivity;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/**
 * The robot as a vacuum in Home Assistant. Each command presses the controller's buttons until the new model is in the
 * state to which the button of that name leads from On, so that a function assigned to that state runs. The commands
 * that end something never switch the robot on or drive it off its base.
 */
final class RoombaVacuum implements Vacuum {
    private static final State ON = new State(RobotEvents.STATE_ON);
    private static final int TUNE = 4;
    private static final List<Note> NOTES =
            List.of(new Note(72, 16), new Note(76, 16), new Note(79, 16), new Note(84, 32));

    /** What each command does is what its button does in On. */
    private static final Map<Order, String> BUTTONS = Map.of(
            Order.START, RobotEvents.CLEAN,
            Order.CLEAN_SPOT, RobotEvents.SPOT,
            Order.RETURN_TO_BASE, RobotEvents.DOCK);

    /** Leaving these by a button switches the robot on or drives it off its base. */
    private static final Set<String> RESTING = Set.of(
            RobotEvents.STATE_OFF, RobotEvents.STATE_ASLEEP, RobotEvents.STATE_CHARGING, RobotEvents.STATE_CHARGED);

    private final HomeAssistant home;
    private final RoombaSession session;
    private final SystemEventConverter converter;
    private boolean paused;
    private boolean rested;

    RoombaVacuum(HomeAssistant home, RoombaSession session, SystemEventConverter converter) {
        this.home = home;
        this.session = session;
        this.converter = converter;
    }

    @Override
    public Activity activity(ConverterStatus status) {
        ConverterStatus.LinkStatus link = status.link();
        if (link != null && !link.up()) {
            // On its dock a robot also sleeps when it was not allowed to.
            return session.isSilent() && isAtDock() ? Activity.DOCKED : Activity.ERROR;
        }
        Activity drawn = activity(
                status.states().evolved().name(), status.states().original().name());
        if (drawn != Activity.IDLE) {
            // Until it rests, it still does the work that is to be interrupted.
            paused &= !rested;
            rested = false;
            return drawn;
        }
        rested = true;
        return isAtDock() ? Activity.DOCKED : paused ? Activity.PAUSED : Activity.IDLE;
    }

    private Activity activity(String evolved, String original) {
        return switch (evolved) {
            case RobotEvents.STATE_CLEAN, RobotEvents.STATE_SPOT, RobotEvents.MAX -> Activity.CLEANING;
            case RobotEvents.STATE_DOCK -> Activity.RETURNING;
            case RobotEvents.STATE_CHARGING, RobotEvents.STATE_CHARGED -> Activity.DOCKED;
            case RobotEvents.STATE_ERROR -> Activity.ERROR;
            case RobotEvents.STATE_OFF, RobotEvents.STATE_ON, RobotEvents.STATE_ASLEEP -> Activity.IDLE;
            default -> isMove(evolved) ? Activity.CLEANING : evolved.equals(original) ? Activity.IDLE : ofNew(original);
        };
    }

    /** Whether the robot is driving to a place that it will clean. */
    private boolean isMove(String state) {
        return models().evolved().hasTrigger(new State(state), new Event(Move.ARRIVED));
    }

    /** A new state in which the robot is at rest counts as waiting; otherwise the robot's own activity is shown. */
    private Activity ofNew(String original) {
        Activity device = activity(original, original);
        return device != Activity.IDLE ? device : isAtDock() ? Activity.DOCKED : Activity.PAUSED;
    }

    @Override
    public Set<Order> commands() {
        StateMachine evolved = models().evolved();
        Set<Order> offered = EnumSet.of(Order.LOCATE);
        if (evolved.hasState(ON)) {
            offered.addAll(List.of(Order.STOP, Order.PAUSE));
        }
        BUTTONS.forEach((command, button) -> {
            if (evolved.nextState(ON, new Event(button)).isPresent()) {
                offered.add(command);
            }
        });
        return offered;
    }

    @Override
    public void perform(Order command) {
        switch (command) {
            case START, CLEAN_SPOT -> home.goTo(where(command));
            case RETURN_TO_BASE -> returnToBase();
            case STOP, PAUSE -> {
                if (!stop()) {
                    paused &= command == Order.PAUSE;
                    return;
                }
            }
            case LOCATE -> locate();
        }
        if (command != Order.LOCATE) {
            paused = command == Order.PAUSE;
            rested = false;
        }
    }

    private void returnToBase() {
        Configuration now = converter.status().states();
        if (isOnBase(now)) {
            home.stay();
        } else if (now.original().name().equals(RobotEvents.STATE_OFF)) {
            throw new IllegalStateException("the robot is off, and going home would switch it on; start it first");
        } else {
            home.goTo(where(Order.RETURN_TO_BASE), RoombaVacuum::isAwakeOnTheFloor);
        }
    }

    /** Ends the robot's work or a function. Returns false if there is nothing to end. */
    private boolean stop() {
        Configuration now = converter.status().states();
        boolean onBase = isOnBase(now);
        boolean works = RobotEvents.activity(now.original()).isWork() && !onBase;
        if (now.evolved().equals(now.original()) && !works) {
            home.stay();
            return false;
        }
        if (RESTING.contains(now.original().name())) {
            throw new IllegalStateException("the robot is in " + now.original() + ", and ending " + now.evolved()
                    + " would " + (onBase ? "drive it off its base" : "switch it on"));
        }
        home.goTo(ON, state -> !onBase && isAwakeOnTheFloor(state));
        return true;
    }

    private static boolean isAwakeOnTheFloor(State state) {
        return !RESTING.contains(state.name());
    }

    /** Whether it is on its dock, and not just leaving it. */
    private boolean isOnBase(Configuration now) {
        EstimatedActivity activity = RobotEvents.activity(now.original());
        return isAtDock() && (!activity.isWork() || activity == EstimatedActivity.DOCK);
    }

    /** Whether its last frame shows the dock; a robot that sleeps or is silent is still there. */
    private boolean isAtDock() {
        Telemetry last = session.latest();
        return last != null && last.values().onHomeBase();
    }

    private ModelPair models() {
        return converter.knowledge().models();
    }

    private State where(Order command) {
        String button = requireNonNull(BUTTONS.get(command));
        return models().evolved()
                .nextState(ON, new Event(button))
                .orElseThrow(() -> new IllegalStateException("the new model does not say what " + button + " does in "
                        + ON + "; draw it, or take another model"));
    }

    private void locate() {
        if (!session.isUnderControl()) {
            throw new IllegalStateException(
                    "the robot plays its tune only while it is under control: on, and not cleaning or on its dock");
        }
        session.send(new ActuatorCommand.Song(TUNE, NOTES));
        session.send(new ActuatorCommand.Play(TUNE));
    }
}
