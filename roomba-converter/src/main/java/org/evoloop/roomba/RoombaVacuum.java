package org.evoloop.roomba;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.mqtt.home.HomeEntity;
import org.evoloop.mqtt.home.HomeKind;
import org.evoloop.roomba.move.Move;
import org.evoloop.roomba.oi.ActuatorCommand;
import org.evoloop.roomba.oi.ActuatorCommand.Song.Note;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.Telemetry;
import org.evoloop.roomba.session.inference.ActivityEstimate.EstimatedActivity;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.jspecify.annotations.Nullable;

/**
 * The robot as a vacuum in Home Assistant. Each command leads to the state to which the button of that name leads from On,
 * so that a function assigned to that state runs. The commands that end something never switch the robot on or drive it off
 * its base.
 */
final class RoombaVacuum implements HomeEntity.Hooks {
    static final String START = "start";
    static final String STOP = "stop";
    static final String PAUSE = "pause";
    static final String RETURN = "return_to_base";
    static final String CLEAN_SPOT = "clean_spot";
    static final String LOCATE = "locate";
    private static final String DOCKED = "docked";
    private static final String IDLE = "idle";
    private static final String PAUSED = "paused";

    private static final State ON = new State(RobotEvents.STATE_ON);
    private static final int TUNE = 4;
    private static final List<Note> NOTES =
            List.of(new Note(72, 16), new Note(76, 16), new Note(79, 16), new Note(84, 32));

    /** What each command does is what its button does in On. */
    private static final Map<String, String> BUTTONS =
            Map.of(START, RobotEvents.CLEAN, CLEAN_SPOT, RobotEvents.SPOT, RETURN, RobotEvents.DOCK);

    /** Leaving these by a button switches the robot on or drives it off its base. */
    private static final Set<String> RESTING = Set.of(
            RobotEvents.STATE_OFF, RobotEvents.STATE_ASLEEP, RobotEvents.STATE_CHARGING, RobotEvents.STATE_CHARGED);

    private final RoombaSession session;
    private final SystemEventConverter converter;
    private boolean paused;
    private boolean rested;

    RoombaVacuum(RoombaSession session, SystemEventConverter converter) {
        this.session = session;
        this.converter = converter;
    }

    /** The entity. */
    HomeEntity entity() {
        return HomeEntity.of(HomeKind.VACUUM).hooks(this);
    }

    @Override
    public String shown(ConverterStatus now, @Nullable String byState) {
        ConverterStatus.LinkStatus link = now.link();
        if (link != null && !link.up()) {
            // On its dock a robot also sleeps when it was not allowed to.
            return session.isSilent() && isAtDock() ? DOCKED : "error";
        }
        String drawn = drawn(now.states(), byState == null ? IDLE : byState);
        if (!drawn.equals(IDLE)) {
            // Until it rests, it still does the work that is to be interrupted.
            paused &= !rested;
            rested = false;
            return drawn;
        }
        rested = true;
        return isAtDock() ? DOCKED : paused ? PAUSED : IDLE;
    }

    /** In a new state in which it waits, what the robot itself does is shown. */
    private String drawn(Configuration now, String byState) {
        boolean waits = byState.equals(PAUSED) && !now.evolved().equals(now.original());
        String device = waits ? HomeKind.VACUUM.shownBy(now.original().name()) : byState;
        return device != null && !(waits && device.equals(IDLE)) ? device : isAtDock() ? DOCKED : PAUSED;
    }

    /** A new state counts as waiting, unless the robot drives in it to a place that it will clean. */
    @Override
    public String shown(State state, ModelPair models) {
        return models.evolved().hasTrigger(state, new Event(Move.ARRIVED)) ? "cleaning" : PAUSED;
    }

    @Override
    public Set<String> commands() {
        return Set.of(LOCATE);
    }

    @Override
    public @Nullable List<State> goals(String command, StateMachine evolved) {
        String button = BUTTONS.get(command);
        if (button == null) {
            return evolved.alike(ON);
        }
        return evolved.nextState(ON, new Event(button)).map(evolved::alike).orElse(List.of());
    }

    @Override
    public boolean begins(String command, ConverterStatus now) {
        boolean begins = switch (command) {
            case START, CLEAN_SPOT -> isDrawn(command);
            case RETURN -> returns(now.states());
            case STOP, PAUSE -> ends(now.states());
            case LOCATE -> locate();
            default -> true;
        };
        if (begins) {
            paused = command.equals(PAUSE);
            rested = false;
        } else if (command.equals(STOP)) {
            paused = false;
        }
        return begins;
    }

    private boolean isDrawn(String command) {
        StateMachine evolved = converter.knowledge().models().evolved();
        List<State> goals = goals(command, evolved);
        if (goals == null || goals.isEmpty()) {
            throw new IllegalStateException("the new model does not say what " + BUTTONS.get(command) + " does in " + ON
                    + "; draw it, or take another model");
        }
        return true;
    }

    private boolean returns(Configuration now) {
        if (isOnBase(now)) {
            return false;
        }
        if (now.original().name().equals(RobotEvents.STATE_OFF)) {
            throw new IllegalStateException("the robot is off, and going home would switch it on; start it first");
        }
        return isDrawn(RETURN);
    }

    /** Whether there is work or a function to end. */
    private boolean ends(Configuration now) {
        boolean onBase = isOnBase(now);
        boolean works = RobotEvents.activity(now.original()).isWork() && !onBase;
        if (now.evolved().equals(now.original()) && !works) {
            return false;
        }
        if (RESTING.contains(now.original().name())) {
            throw new IllegalStateException("the robot is in " + now.original() + ", and ending " + now.evolved()
                    + " would " + (onBase ? "drive it off its base" : "switch it on"));
        }
        return true;
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

    private boolean locate() {
        if (!session.isUnderControl()) {
            throw new IllegalStateException(
                    "the robot plays its tune only while it is under control: on, and not cleaning or on its dock");
        }
        session.send(new ActuatorCommand.Song(TUNE, NOTES));
        session.send(new ActuatorCommand.Play(TUNE));
        return false;
    }
}
