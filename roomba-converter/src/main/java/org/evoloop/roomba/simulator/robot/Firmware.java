package org.evoloop.roomba.simulator.robot;

import java.util.Set;
import java.util.function.Consumer;
import org.evoloop.roomba.oi.ActuatorCommand;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.InputCommand;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.simulator.behavior.Behavior;
import org.evoloop.roomba.simulator.behavior.Cleaning;
import org.evoloop.roomba.simulator.behavior.SpotCleaning;
import org.evoloop.roomba.simulator.behavior.Wandering;
import org.evoloop.roomba.simulator.body.Body;
import org.jspecify.annotations.Nullable;

/**
 * The robot's program from one boot to the next: it holds mode and activity, and moves both as the specification says in
 * "Open Interface Modes" and the commands' descriptions. What the specification leaves open follows robots in the field:
 * a press is seen in packet 18 and obeyed at once, and cleaning commands start from standby too.
 */
final class Firmware {
    /** How long the robot holds down what command Buttons presses: 1/6 s. */
    private static final int COMMANDED_PRESS_MILLIS = 167;

    private final Body body;
    private final RobotOptions options;
    private final ButtonPanel buttons = new ButtonPanel();
    private final Speaker speaker = new Speaker();
    private final Actuators actuators;
    private final Reporter reporter;
    private OiMode mode = OiMode.OFF;
    private Activity activity = Activity.OFF;
    private @Nullable Behavior behavior;

    Firmware(Body body, RobotOptions options, Consumer<byte[]> sink) {
        this.body = body;
        this.options = options;
        this.actuators = new Actuators(body);
        this.reporter = new Reporter(new Sensors(body, this)::value, sink);
    }

    /** Obeys a command, or ignores it if the mode does not accept it. */
    void execute(Command command) {
        if (!command.opcode().isAcceptedIn(mode)) {
            return;
        }
        if (command instanceof InputCommand input) {
            reporter.execute(input);
        } else if (command instanceof ActuatorCommand actuator) {
            actuate(actuator);
        } else {
            control(command);
        }
    }

    private void control(Command command) {
        switch (command.opcode()) {
            case START -> enter(OiMode.PASSIVE);
            case STOP -> {
                enter(OiMode.OFF);
                reporter.endStream();
            }
            case CONTROL, SAFE -> takeControl(OiMode.SAFE);
            case FULL -> takeControl(OiMode.FULL);
            case POWER -> {
                enter(OiMode.PASSIVE);
                rest(Activity.OFF);
            }
            case CLEAN, MAX -> startOrPause(Activity.CLEAN);
            case SPOT -> startOrPause(Activity.SPOT);
            case SEEK_DOCK -> startOrPause(Activity.DOCK);
            // The line's rate means nothing to a simulation, and nobody waits for the schedule's day.
            default -> {}
        }
    }

    private void actuate(ActuatorCommand command) {
        if (command instanceof ActuatorCommand.Buttons press) {
            for (Button button : press.pressed()) {
                press(button, COMMANDED_PRESS_MILLIS);
            }
        } else if (command instanceof ActuatorCommand.Drive drive) {
            actuators.drive(drive);
        } else if (command instanceof ActuatorCommand.DriveDirect drive) {
            actuators.drive(drive);
        } else if (command instanceof ActuatorCommand.DrivePwm drive) {
            actuators.drive(drive);
        } else if (command instanceof ActuatorCommand.Motors motors) {
            actuators.clean(motors);
        } else if (command instanceof ActuatorCommand.PwmMotors motors) {
            actuators.clean(motors);
        } else if (command instanceof ActuatorCommand.Song song) {
            speaker.store(song);
        } else if (command instanceof ActuatorCommand.Play play) {
            speaker.play(play.song());
        }
    }

    /** Somebody presses a button; the robot obeys as it goes down, unless a client has control. */
    void press(Button button, int durationMillis) {
        if (buttons.press(button, durationMillis) && !isControlled()) {
            obey(button);
        }
    }

    private void obey(Button button) {
        switch (button) {
            case CLEAN -> {
                if (activity == Activity.OFF) {
                    rest(Activity.ON);
                } else {
                    toggle(Activity.CLEAN);
                }
            }
            case SPOT -> toggleUnlessOff(Activity.SPOT);
            case DOCK -> toggleUnlessOff(Activity.DOCK);
            case MINUTE, HOUR, DAY, SCHEDULE, CLOCK -> {}
        }
    }

    private void toggleUnlessOff(Activity wanted) {
        if (activity != Activity.OFF) {
            toggle(wanted);
        }
    }

    private void startOrPause(Activity wanted) {
        enter(OiMode.PASSIVE);
        toggle(wanted);
    }

    private void toggle(Activity wanted) {
        if (activity.isRunning()) {
            rest(Activity.ON);
        } else {
            activity = wanted;
            behavior = begin(wanted);
        }
    }

    private Behavior begin(Activity wanted) {
        return switch (wanted) {
            case SPOT -> new SpotCleaning(body.pose(), options.spotDurationMillis());
            case DOCK -> new Wandering();
            default -> new Cleaning(body.pose());
        };
    }

    private void takeControl(OiMode wanted) {
        if (activity.isRunning()) {
            rest(Activity.ON);
        }
        activity = Activity.ON;
        mode = wanted;
    }

    /** Goes to a mode in which the client has no control, so what it set in motion stops. */
    private void enter(OiMode wanted) {
        if (isControlled()) {
            body.stop();
        }
        mode = wanted;
    }

    private void rest(Activity wanted) {
        body.stop();
        behavior = null;
        activity = wanted;
    }

    private boolean isControlled() {
        return mode == OiMode.SAFE || mode == OiMode.FULL;
    }

    /** The first half of a tick: what the robot does by itself. */
    void act() {
        if (behavior != null && !behavior.steer(body)) {
            rest(Activity.ON);
        }
        speaker.tick();
    }

    /** The second half of a tick, after the body has moved: what the robot tells. */
    void report() {
        reporter.tick();
        buttons.tick();
    }

    OiMode mode() {
        return mode;
    }

    Activity activity() {
        return activity;
    }

    Set<Button> pressed() {
        return buttons.pressed();
    }

    Speaker speaker() {
        return speaker;
    }

    Actuators actuators() {
        return actuators;
    }

    Reporter reporter() {
        return reporter;
    }
}
