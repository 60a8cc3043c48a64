package org.evoloop.roomba.oi;

import java.nio.charset.StandardCharsets;
import java.time.DayOfWeek;
import java.time.LocalTime;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** Decodes a command from its opcode and data bytes; the inverse of {@link Command#bytes()}. */
final class CommandDecoder {
    private CommandDecoder() {}

    /**
     * @param data as many bytes as the opcode has
     * @throws IllegalArgumentException if a value is out of its range
     */
    static Command decode(Opcode opcode, byte[] data) {
        return switch (opcode) {
            case RESET -> new Command.Reset();
            case START -> new Command.Start();
            case STOP -> new Command.Stop();
            case BAUD -> baud(Bytes.unsigned8(data, 0));
            case CONTROL -> new Command.Control();
            case SAFE -> new Command.Safe();
            case FULL -> new Command.Full();
            case POWER -> new Command.Power();
            case SPOT -> new Command.Spot();
            case CLEAN -> new Command.Clean();
            case MAX -> new Command.Max();
            case SEEK_DOCK -> new Command.SeekDock();
            case SCHEDULE -> schedule(data);
            case SET_DAY_TIME -> new Command.SetDayTime(day(Bytes.unsigned8(data, 0)), time(data, 1));
            case DRIVE -> new ActuatorCommand.Drive(Bytes.signed16(data, 0), Bytes.signed16(data, 2));
            case DRIVE_DIRECT -> new ActuatorCommand.DriveDirect(Bytes.signed16(data, 0), Bytes.signed16(data, 2));
            case DRIVE_PWM -> new ActuatorCommand.DrivePwm(Bytes.signed16(data, 0), Bytes.signed16(data, 2));
            case MOTORS -> new ActuatorCommand.Motors(Bytes.unsigned8(data, 0));
            case PWM_MOTORS -> new ActuatorCommand.PwmMotors(data[0], data[1], data[2]);
            case LEDS ->
                new ActuatorCommand.Leds(Bytes.unsigned8(data, 0), Bytes.unsigned8(data, 1), Bytes.unsigned8(data, 2));
            case SCHEDULING_LEDS ->
                new ActuatorCommand.SchedulingLeds(Bytes.unsigned8(data, 0), Bytes.unsigned8(data, 1));
            case DIGIT_LEDS_RAW ->
                new ActuatorCommand.DigitLedsRaw(
                        Bytes.unsigned8(data, 0),
                        Bytes.unsigned8(data, 1),
                        Bytes.unsigned8(data, 2),
                        Bytes.unsigned8(data, 3));
            case DIGIT_LEDS_ASCII -> new ActuatorCommand.DigitLedsAscii(new String(data, StandardCharsets.ISO_8859_1));
            case BUTTONS -> new ActuatorCommand.Buttons(Button.fromBits(Bytes.unsigned8(data, 0)));
            case SONG -> song(data);
            case PLAY -> new ActuatorCommand.Play(Bytes.unsigned8(data, 0));
            case SENSORS -> new InputCommand.Sensors(packet(Bytes.unsigned8(data, 0)));
            case STREAM -> new InputCommand.Stream(packets(data));
            case QUERY_LIST -> new InputCommand.QueryList(packets(data));
            case PAUSE_RESUME_STREAM -> pauseResume(Bytes.unsigned8(data, 0));
        };
    }

    /** The valid wheel command nearest to one out of its range; null for other commands. */
    static @Nullable Command nearest(Opcode opcode, byte[] data) {
        return switch (opcode) {
            case DRIVE -> ActuatorCommand.Drive.nearest(Bytes.signed16(data, 0), Bytes.signed16(data, 2));
            case DRIVE_DIRECT -> ActuatorCommand.DriveDirect.nearest(Bytes.signed16(data, 0), Bytes.signed16(data, 2));
            case DRIVE_PWM -> ActuatorCommand.DrivePwm.nearest(Bytes.signed16(data, 0), Bytes.signed16(data, 2));
            default -> null;
        };
    }

    private static Command baud(int code) {
        Bytes.requireRange("baud code", code, 0, Command.Baud.RATES.size() - 1, "");
        return new Command.Baud(Command.Baud.RATES.get(code));
    }

    private static Command pauseResume(int state) {
        Bytes.requireRange("stream state", state, 0, 1, "");
        return new InputCommand.PauseResumeStream(state == 1);
    }

    private static Command schedule(byte[] data) {
        int days = Bytes.unsigned8(data, 0);
        Bytes.requireRange("days", days, 0, 127, "");
        Map<DayOfWeek, LocalTime> times = new EnumMap<>(DayOfWeek.class);
        for (int number = 0; number < 7; number++) {
            if (Bytes.hasBit(days, number)) {
                times.put(day(number), time(data, 1 + 2 * number));
            }
        }
        return new Command.Schedule(times);
    }

    private static DayOfWeek day(int number) {
        Bytes.requireRange("day", number, 0, 6, "");
        return number == 0 ? DayOfWeek.SUNDAY : DayOfWeek.of(number);
    }

    private static LocalTime time(byte[] data, int offset) {
        int hour = Bytes.unsigned8(data, offset);
        int minute = Bytes.unsigned8(data, offset + 1);
        Bytes.requireRange("hour", hour, 0, 23, "h");
        Bytes.requireRange("minute", minute, 0, 59, "min");
        return LocalTime.of(hour, minute);
    }

    private static Command song(byte[] data) {
        List<ActuatorCommand.Song.Note> notes = new ArrayList<>();
        for (int i = 2; i < data.length; i += 2) {
            notes.add(new ActuatorCommand.Song.Note(Bytes.unsigned8(data, i), Bytes.unsigned8(data, i + 1)));
        }
        return new ActuatorCommand.Song(Bytes.unsigned8(data, 0), notes);
    }

    private static List<PacketId> packets(byte[] data) {
        List<PacketId> packets = new ArrayList<>();
        for (int i = 1; i < data.length; i++) {
            packets.add(packet(Bytes.unsigned8(data, i)));
        }
        return packets;
    }

    private static PacketId packet(int id) {
        return PacketId.of(id)
                .orElseThrow(() -> new IllegalArgumentException(
                        "packet id is " + id + "; allowed is 0 to 58, 100, 101, 106 and 107"));
    }
}
