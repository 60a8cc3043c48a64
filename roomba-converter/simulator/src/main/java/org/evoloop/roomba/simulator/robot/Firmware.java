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
import org.evoloop.roomba.simulator.behavior.DockSeeking;
import org.evoloop.roomba.simulator.behavior.SpotCleaning;
import org.evoloop.roomba.simulator.body.Body;
import org.evoloop.roomba.simulator.body.Surroundings;
import org.jspecify.annotations.Nullable;

/**
 * The robot's program from one boot to the next: it holds mode and activity, and moves both as the specification says
 * in "Open Interface Modes" and the commands' descriptions. What the specification leaves open follows robots in the
 * field: a press is seen in packet 18 and obeyed at once, and cleaning commands start from standby too.
 */
final class Firmware {
    /** How long the robot holds down what command Buttons presses: 1/6 s. */
    private static final int COMMANDED_PRESS_MILLIS = 167;

    /** After this idle time in Passive mode the robot falls asleep. */
    private static final int TIRED_TICKS = 5 * 60_000 / Body.TICK_MILLIS;

    private static final int TICKS_PER_SECOND = 1000 / Body.TICK_MILLIS;

    private final Body body;
    private final RobotOptions options;
    private final ButtonPanel buttons = new ButtonPanel();
    private final Speaker speaker = new Speaker();
    private final Actuators actuators;
    private final Reporter reporter;
    private final Consumer<byte[]> sink;
    private OiMode mode = OiMode.OFF;
    private RobotActivity activity = RobotActivity.OFF;
    private @Nullable Behavior behavior;
    private boolean untilEmpty;
    private boolean wasDocked;
    private boolean digestsModeChange;
    private int idleTicks;
    private long chargingTicks;

    Firmware(Body body, RobotOptions options, Consumer<byte[]> sink) {
        this.body = body;
        this.options = options;
        this.actuators = new Actuators(body);
        this.reporter = new Reporter(new Sensors(body, this, options)::value, options.checksum(), sink);
        this.sink = sink;
        this.wasDocked = body.surroundings().docked();
    }

    /** Obeys a command, or ignores it if the mode does not accept it. */
    void execute(Command command) {
        if (digestsModeChange || !command.opcode().isAcceptedIn(mode)) {
            return;
        }
        digestsModeChange = options.strictModeWindow() && command.opcode().changesMode();
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
                rest(RobotActivity.OFF);
            }
            case CLEAN -> startOrPause(RobotActivity.CLEAN);
            case MAX -> {
                startOrPause(RobotActivity.CLEAN);
                untilEmpty = true;
            }
            case SPOT -> startOrPause(RobotActivity.SPOT);
            case SEEK_DOCK -> startOrPause(RobotActivity.DOCK);
            // The rate is handled elsewhere, and schedules are not simulated.
            default -> {}
        }
    }

    private void actuate(ActuatorCommand command) {
        if (command instanceof ActuatorCommand.Buttons press) {
            for (Button button : press.pressed()) {
                idleTicks = 0;
                if (buttons.hold(button, COMMANDED_PRESS_MILLIS)) {
                    wentDown(button);
                }
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

    /** A person presses a button, now or when it is released. */
    void press(Button button, int durationMillis) {
        idleTicks = 0;
        if (buttons.press(button, durationMillis)) {
            wentDown(button);
        }
    }

    /** The robot obeys its buttons as they go down, unless a client has control. */
    private void wentDown(Button button) {
        if (!isControlled()) {
            obey(button);
        }
    }

    private void obey(Button button) {
        switch (button) {
            case CLEAN -> {
                if (activity == RobotActivity.OFF) {
                    rest(RobotActivity.ON);
                } else {
                    toggle(RobotActivity.CLEAN);
                }
            }
            case SPOT -> toggleUnlessOff(RobotActivity.SPOT);
            case DOCK -> toggleUnlessOff(RobotActivity.DOCK);
            case MINUTE, HOUR, DAY, SCHEDULE, CLOCK -> {}
        }
    }

    private void toggleUnlessOff(RobotActivity wanted) {
        if (activity != RobotActivity.OFF) {
            toggle(wanted);
        }
    }

    private void startOrPause(RobotActivity wanted) {
        enter(OiMode.PASSIVE);
        toggle(wanted);
    }

    private void toggle(RobotActivity wanted) {
        if (activity.isRunning()) {
            rest(RobotActivity.ON);
        } else {
            begin(wanted);
        }
    }

    private void begin(RobotActivity wanted) {
        activity = wanted;
        untilEmpty = false;
        behavior = switch (wanted) {
            case SPOT -> new SpotCleaning(body.pose(), options.spotDurationMillis());
            case DOCK -> new DockSeeking();
            default -> new Cleaning(body.pose());
        };
    }

    private void takeControl(OiMode wanted) {
        if (activity.isRunning()) {
            rest(RobotActivity.ON);
        }
        activity = RobotActivity.ON;
        mode = wanted;
        protect();
    }

    /** In Safe mode: gives the control up where the specification says so, and stops all motors. */
    private void protect() {
        if (mode != OiMode.SAFE) {
            return;
        }
        Surroundings surroundings = body.surroundings();
        boolean cliff = !surroundings.cliffs().isEmpty() && body.isMovingForwardOrTightly();
        if (cliff || !surroundings.wheelDrops().isEmpty() || surroundings.docked()) {
            enter(OiMode.PASSIVE);
        }
    }

    /** Goes to a mode in which the client has no control, so what it set in motion stops. */
    private void enter(OiMode wanted) {
        if (isControlled()) {
            body.stop();
        }
        mode = wanted;
    }

    private void rest(RobotActivity wanted) {
        body.stop();
        behavior = null;
        activity = wanted;
    }

    private boolean isControlled() {
        return mode == OiMode.SAFE || mode == OiMode.FULL;
    }

    /** The first half of a tick: what the robot does by itself. */
    void act() {
        boolean docked = body.surroundings().docked();
        if (docked && !wasDocked && activity.isRunning()) {
            rest(RobotActivity.ON);
        }
        wasDocked = docked;
        body.allowCharger(!isControlled() && !activity.isRunning());
        if (behavior != null) {
            boolean canMove = body.surroundings().wheelDrops().isEmpty();
            if (!canMove || !behavior.steer(body)) {
                rest(RobotActivity.ON);
            } else if (activity == RobotActivity.CLEAN
                    && !untilEmpty
                    && body.battery().isLow()) {
                goHome();
            }
        }
        speaker.tick();
    }

    private void goHome() {
        rest(RobotActivity.ON);
        if (body.room().dock().isPresent()) {
            begin(RobotActivity.DOCK);
        }
    }

    /** The second half of a tick, after the body has moved: the robot's output. */
    void report() {
        protect();
        digestsModeChange = false;
        idleTicks = mode == OiMode.PASSIVE && !activity.isRunning() && !body.isCharging() ? idleTicks + 1 : 0;
        chargingTicks = body.isCharging() ? chargingTicks + 1 : 0;
        if (chargingTicks % TICKS_PER_SECOND == 1) {
            sink.accept(RobotText.charging(body, chargingTicks / TICKS_PER_SECOND));
        }
        reporter.tick();
        buttons.tick().forEach(this::wentDown);
    }

    /** The wake line was used. */
    void stayAwake() {
        idleTicks = 0;
    }

    /** Whether the robot has been idle long enough to fall asleep. */
    boolean isTired() {
        return idleTicks >= TIRED_TICKS;
    }

    OiMode mode() {
        return mode;
    }

    RobotActivity activity() {
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
