package org.evoloop.roomba.oi;

import static org.quicktheories.generators.Generate.constant;
import static org.quicktheories.generators.Generate.enumValues;
import static org.quicktheories.generators.Generate.pick;
import static org.quicktheories.generators.Generate.range;
import static org.quicktheories.generators.SourceDSL.lists;
import static org.quicktheories.generators.SourceDSL.strings;

import java.time.DayOfWeek;
import java.time.LocalTime;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.evoloop.roomba.oi.ActuatorCommand.Song.Note;
import org.quicktheories.core.Gen;

/** Random valid values of the Open Interface. */
final class RandomCommands {
    private RandomCommands() {}

    static Gen<Command> any() {
        return enumValues(Opcode.class).flatMap(RandomCommands::of);
    }

    static Gen<Command> of(Opcode opcode) {
        return switch (opcode) {
            case RESET -> constant(new Command.Reset());
            case START -> constant(new Command.Start());
            case STOP -> constant(new Command.Stop());
            case CONTROL -> constant(new Command.Control());
            case SAFE -> constant(new Command.Safe());
            case FULL -> constant(new Command.Full());
            case POWER -> constant(new Command.Power());
            case SPOT -> constant(new Command.Spot());
            case CLEAN -> constant(new Command.Clean());
            case MAX -> constant(new Command.Max());
            case SEEK_DOCK -> constant(new Command.SeekDock());
            case BAUD -> pick(Command.Baud.RATES).map(Command.Baud::new);
            case SCHEDULE ->
                range(0, 127)
                        .zip(lists().of(times()).ofSize(7), RandomCommands::week)
                        .map(Command.Schedule::new);
            case SET_DAY_TIME -> enumValues(DayOfWeek.class).zip(times(), Command.SetDayTime::new);
            case DRIVE ->
                velocities()
                        .zip(
                                range(-2000, 2000).mix(pick(List.of(32767, -32768, 1, -1)), 30),
                                ActuatorCommand.Drive::new);
            case DRIVE_DIRECT -> velocities().zip(velocities(), ActuatorCommand.DriveDirect::new);
            case DRIVE_PWM -> range(-255, 255).zip(range(-255, 255), ActuatorCommand.DrivePwm::new);
            case MOTORS -> range(0, 31).map(ActuatorCommand.Motors::new);
            case PWM_MOTORS -> range(-127, 127).zip(range(-127, 127), range(0, 127), ActuatorCommand.PwmMotors::new);
            case LEDS -> range(0, 15).zip(range(0, 255), range(0, 255), ActuatorCommand.Leds::new);
            case SCHEDULING_LEDS -> range(0, 127).zip(range(0, 31), ActuatorCommand.SchedulingLeds::new);
            case DIGIT_LEDS_RAW ->
                range(0, 127).zip(range(0, 127), range(0, 127), range(0, 127), ActuatorCommand.DigitLedsRaw::new);
            case DIGIT_LEDS_ASCII ->
                strings().betweenCodePoints(32, 126).ofLength(4).map(ActuatorCommand.DigitLedsAscii::new);
            case BUTTONS -> range(0, 255).map(bits -> new ActuatorCommand.Buttons(Button.fromBits(bits)));
            case SONG ->
                range(0, 4)
                        .zip(
                                lists().of(range(0, 255).zip(range(0, 255), Note::new))
                                        .ofSizeBetween(1, 255),
                                ActuatorCommand.Song::new);
            case PLAY -> range(0, 4).map(ActuatorCommand.Play::new);
            case SENSORS -> packetIds().map(InputCommand.Sensors::new);
            case STREAM -> streamable().map(InputCommand.Stream::new);
            case QUERY_LIST -> lists().of(packetIds()).ofSizeBetween(0, 255).map(InputCommand.QueryList::new);
            case PAUSE_RESUME_STREAM -> pick(List.of(true, false)).map(InputCommand.PauseResumeStream::new);
        };
    }

    static Gen<PacketId> packetIds() {
        List<PacketId> all = new ArrayList<>(List.of(Packet.values()));
        all.addAll(List.of(PacketGroup.values()));
        return pick(all);
    }

    /** Lists that fit into a frame: three times the longest group takes 243 bytes. */
    static Gen<List<PacketId>> streamable() {
        return lists().of(packetIds()).ofSizeBetween(0, 3);
    }

    private static Gen<Integer> velocities() {
        return range(-500, 500);
    }

    private static Gen<LocalTime> times() {
        return range(0, 23).zip(range(0, 59), LocalTime::of);
    }

    private static Map<DayOfWeek, LocalTime> week(int days, List<LocalTime> times) {
        Map<DayOfWeek, LocalTime> week = new EnumMap<>(DayOfWeek.class);
        for (DayOfWeek day : DayOfWeek.values()) {
            if (Bytes.hasBit(days, day.getValue() - 1)) {
                week.put(day, times.get(day.getValue() - 1));
            }
        }
        return week;
    }
}
