package org.evoloop.roomba.oi;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * The first byte of every command, how many data bytes follow it, and in which modes the robot accepts it
 * (specification, "Open Interface Commands Quick Reference"). In other modes the robot consumes and ignores it.
 *
 * @since 0.1
 */
public enum Opcode {
    /** {@link Command.Reset}. */
    RESET(7, Command.Reset.class, OiMode.OFF, 0),
    /** {@link Command.Start}. */
    START(128, Command.Start.class, OiMode.OFF, 0),
    /** {@link Command.Baud}. */
    BAUD(129, Command.Baud.class, OiMode.PASSIVE, 1),
    /** {@link Command.Control}. */
    CONTROL(130, Command.Control.class, OiMode.PASSIVE, 0),
    /** {@link Command.Safe}. */
    SAFE(131, Command.Safe.class, OiMode.PASSIVE, 0),
    /** {@link Command.Full}. */
    FULL(132, Command.Full.class, OiMode.PASSIVE, 0),
    /** {@link Command.Power}. */
    POWER(133, Command.Power.class, OiMode.PASSIVE, 0),
    /** {@link Command.Spot}. */
    SPOT(134, Command.Spot.class, OiMode.PASSIVE, 0),
    /** {@link Command.Clean}. */
    CLEAN(135, Command.Clean.class, OiMode.PASSIVE, 0),
    /** {@link Command.Max}. */
    MAX(136, Command.Max.class, OiMode.PASSIVE, 0),
    /** {@link ActuatorCommand.Drive}. */
    DRIVE(137, ActuatorCommand.Drive.class, OiMode.SAFE, 4),
    /** {@link ActuatorCommand.Motors}. */
    MOTORS(138, ActuatorCommand.Motors.class, OiMode.SAFE, 1),
    /** {@link ActuatorCommand.Leds}. */
    LEDS(139, ActuatorCommand.Leds.class, OiMode.SAFE, 3),
    /** {@link ActuatorCommand.Song}. */
    SONG(140, ActuatorCommand.Song.class, OiMode.PASSIVE, 2, 2),
    /** {@link ActuatorCommand.Play}. */
    PLAY(141, ActuatorCommand.Play.class, OiMode.SAFE, 1),
    /** {@link InputCommand.Sensors}. */
    SENSORS(142, InputCommand.Sensors.class, OiMode.PASSIVE, 1),
    /** {@link Command.SeekDock}. */
    SEEK_DOCK(143, Command.SeekDock.class, OiMode.PASSIVE, 0),
    /** {@link ActuatorCommand.PwmMotors}. */
    PWM_MOTORS(144, ActuatorCommand.PwmMotors.class, OiMode.SAFE, 3),
    /** {@link ActuatorCommand.DriveDirect}. */
    DRIVE_DIRECT(145, ActuatorCommand.DriveDirect.class, OiMode.SAFE, 4),
    /** {@link ActuatorCommand.DrivePwm}. */
    DRIVE_PWM(146, ActuatorCommand.DrivePwm.class, OiMode.SAFE, 4),
    /** {@link InputCommand.Stream}. */
    STREAM(148, InputCommand.Stream.class, OiMode.PASSIVE, 1, 1),
    /** {@link InputCommand.QueryList}. */
    QUERY_LIST(149, InputCommand.QueryList.class, OiMode.PASSIVE, 1, 1),
    /** {@link InputCommand.PauseResumeStream}. */
    PAUSE_RESUME_STREAM(150, InputCommand.PauseResumeStream.class, OiMode.PASSIVE, 1),
    /** {@link ActuatorCommand.SchedulingLeds}. */
    SCHEDULING_LEDS(162, ActuatorCommand.SchedulingLeds.class, OiMode.SAFE, 2),
    /** {@link ActuatorCommand.DigitLedsRaw}. */
    DIGIT_LEDS_RAW(163, ActuatorCommand.DigitLedsRaw.class, OiMode.SAFE, 4),
    /** {@link ActuatorCommand.DigitLedsAscii}. */
    DIGIT_LEDS_ASCII(164, ActuatorCommand.DigitLedsAscii.class, OiMode.SAFE, 4),
    /** {@link ActuatorCommand.Buttons}. */
    BUTTONS(165, ActuatorCommand.Buttons.class, OiMode.PASSIVE, 1),
    /** {@link Command.Schedule}. */
    SCHEDULE(167, Command.Schedule.class, OiMode.PASSIVE, 15),
    /** {@link Command.SetDayTime}. */
    SET_DAY_TIME(168, Command.SetDayTime.class, OiMode.PASSIVE, 3),
    /** {@link Command.Stop}. */
    STOP(173, Command.Stop.class, OiMode.PASSIVE, 0);

    private static final Map<Integer, Opcode> BY_CODE =
            Arrays.stream(values()).collect(Collectors.toUnmodifiableMap(Opcode::code, Function.identity()));
    private static final Map<Class<? extends Command>, Opcode> BY_TYPE =
            Arrays.stream(values()).collect(Collectors.toUnmodifiableMap(Opcode::type, Function.identity()));

    private static final Set<Opcode> MODE_CHANGING =
            EnumSet.of(RESET, START, CONTROL, SAFE, FULL, POWER, SPOT, CLEAN, MAX, SEEK_DOCK, STOP);

    private final int code;
    private final Class<? extends Command> type;
    private final OiMode lowestMode;
    private final int headBytes;
    private final int itemBytes;

    Opcode(int code, Class<? extends Command> type, OiMode lowestMode, int dataBytes) {
        this(code, type, lowestMode, dataBytes, 0);
    }

    Opcode(int code, Class<? extends Command> type, OiMode lowestMode, int headBytes, int itemBytes) {
        this.code = code;
        this.type = type;
        this.lowestMode = lowestMode;
        this.headBytes = headBytes;
        this.itemBytes = itemBytes;
    }

    /** The first byte, 0 to 255. */
    public int code() {
        return code;
    }

    /** The record of this command. */
    public Class<? extends Command> type() {
        return type;
    }

    /** Whether a robot in this mode obeys the command. */
    public boolean isAcceptedIn(OiMode mode) {
        return mode.compareTo(lowestMode) >= 0;
    }

    /** Whether the command puts the robot into a certain mode, possibly the present one. */
    public boolean changesMode() {
        return MODE_CHANGING.contains(this);
    }

    /**
     * Whether the command acts like one of the robot's cleaning buttons: it starts work, or pauses the work in
     * progress.
     */
    public boolean startsWork() {
        return this == CLEAN || this == SPOT || this == MAX || this == SEEK_DOCK;
    }

    /** Whether the command ends a client's control, so that the robot then acts by itself, or does nothing. */
    public boolean endsControl() {
        return startsWork() || this == POWER;
    }

    /** Data bytes that every such command has; if it has items too, the last of these bytes says how many. */
    int headBytes() {
        return headBytes;
    }

    /** Data bytes of one item; 0 for a command of fixed length. */
    int itemBytes() {
        return itemBytes;
    }

    /** The opcode with this first byte. */
    public static Optional<Opcode> of(int code) {
        return Optional.ofNullable(BY_CODE.get(code));
    }

    static Opcode of(Command command) {
        Opcode opcode = BY_TYPE.get(command.getClass());
        if (opcode == null) {
            throw new IllegalStateException(command.getClass() + " has no row in the table of opcodes");
        }
        return opcode;
    }
}
