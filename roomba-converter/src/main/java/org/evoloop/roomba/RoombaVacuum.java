package org.evoloop.roomba;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.evolution.ModelPair;
import org.evoloop.function.Reading;
import org.evoloop.mqtt.HomeAssistant;
import org.evoloop.mqtt.Vacuum;
import org.evoloop.roomba.move.Move;
import org.evoloop.roomba.oi.ActuatorCommand;
import org.evoloop.roomba.oi.ActuatorCommand.Song.Note;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/**
 * The robot as a vacuum in Home Assistant. Each command presses the controller's buttons until the new model is in the
 * state to which the button of that name leads from On, so that a function assigned to that state runs.
 */
final class RoombaVacuum implements Vacuum {
    private static final State ON = new State(RobotEvents.STATE_ON);
    private static final int TUNE = 4;
    private static final List<Note> NOTES =
            List.of(new Note(72, 16), new Note(76, 16), new Note(79, 16), new Note(84, 32));

    private final HomeAssistant home;
    private final RoombaSession session;
    private final Supplier<ModelPair> models;
    private boolean paused;
    private boolean rested;

    /** @param models supplies the converter's present models */
    RoombaVacuum(HomeAssistant home, RoombaSession session, Supplier<ModelPair> models) {
        this.home = home;
        this.session = session;
        this.models = models;
    }

    @Override
    public Activity activity(ConverterStatus status) {
        ConverterStatus.LinkStatus link = status.link();
        if (link != null && !link.up()) {
            return Activity.ERROR;
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
        boolean docked = link != null && link.readings().contains(Reading.of("docked", true));
        return docked ? Activity.DOCKED : paused ? Activity.PAUSED : Activity.IDLE;
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
        return models.get().evolved().hasTrigger(new State(state), new Event(Move.ARRIVED));
    }

    /** A new state in which the robot is at rest counts as waiting; otherwise the robot's own activity is shown. */
    private Activity ofNew(String original) {
        Activity device = activity(original, original);
        return device == Activity.IDLE ? Activity.PAUSED : device;
    }

    @Override
    public void perform(Command command) {
        switch (command) {
            case START -> home.goTo(where(RobotEvents.CLEAN));
            case CLEAN_SPOT -> home.goTo(where(RobotEvents.SPOT));
            case RETURN_TO_BASE -> home.goTo(where(RobotEvents.DOCK));
            case STOP, PAUSE -> home.goTo(ON);
            case LOCATE -> locate();
        }
        if (command != Command.LOCATE) {
            paused = command == Command.PAUSE;
            rested = false;
        }
    }

    private State where(String button) {
        Optional<State> target = models.get().evolved().nextState(ON, new Event(button));
        return target.orElseThrow(() -> new IllegalStateException(
                "the new model does not say what " + button + " does in " + ON + "; draw it, or take another model"));
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
