package org.evoloop.roomba.oi;

import java.time.DayOfWeek;
import java.time.LocalTime;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Map;

/**
 * A command to the robot (specification, "Roomba Open Interface Commands"). The records here start the interface,
 * change its mode and clean; {@link ActuatorCommand} and {@link InputCommand} hold the others.
 *
 * <p>Every value is checked at construction: an {@link IllegalArgumentException} names the field, the value and what is
 * allowed. Every instance can be sent.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface Command
        permits ActuatorCommand,
                InputCommand,
                Command.Reset,
                Command.Start,
                Command.Stop,
                Command.Baud,
                Command.Control,
                Command.Safe,
                Command.Full,
                Command.Power,
                Command.Spot,
                Command.Clean,
                Command.Max,
                Command.SeekDock,
                Command.Schedule,
                Command.SetDayTime {

    /** The row of the command table that this command belongs to. */
    default Opcode opcode() {
        return Opcode.of(this);
    }

    /** The opcode and its data as they are sent, in a new array. */
    default byte[] bytes() {
        return Bytes.of(opcode());
    }

    /** Like removing the battery: any mode to {@link OiMode#OFF}; the robot prints its boot text. */
    record Reset() implements Command {}

    /** Any mode to {@link OiMode#PASSIVE}. */
    record Start() implements Command {}

    /** Any mode to {@link OiMode#OFF}; streams stop. Not in the specification of the 500 series. */
    record Stop() implements Command {}

    /** The older name of {@link Safe}, with the same effect. */
    record Control() implements Command {}

    /** To {@link OiMode#SAFE}. */
    record Safe() implements Command {}

    /** To {@link OiMode#FULL}. */
    record Full() implements Command {}

    /** Powers down, as the Clean button does when held; to {@link OiMode#PASSIVE}. */
    record Power() implements Command {}

    /** As the Spot button: starts spot cleaning, or pauses the cleaning that is under way; to PASSIVE. */
    record Spot() implements Command {}

    /** As the Clean button: starts cleaning, or pauses the cleaning that is under way; to PASSIVE. */
    record Clean() implements Command {}

    /** Cleans until the battery is empty, or pauses the cleaning that is under way; to PASSIVE. */
    record Max() implements Command {}

    /** As the Dock button: drives onto the dock when it next meets the dock's beams; to PASSIVE. */
    record SeekDock() implements Command {}

    /**
     * Changes the line's speed; wait 100 ms before the next command.
     *
     * @param bitsPerSecond one of {@link #RATES}
     */
    record Baud(int bitsPerSecond) implements Command {
        /** The speeds of the specification, ordered by code. */
        public static final List<Integer> RATES =
                List.of(300, 600, 1200, 2400, 4800, 9600, 14400, 19200, 28800, 38400, 57600, 115200);

        public Baud {
            if (!RATES.contains(bitsPerSecond)) {
                throw new IllegalArgumentException(
                        "bitsPerSecond is " + bitsPerSecond + " bit/s; allowed is one of " + RATES + " bit/s");
            }
        }

        @Override
        public byte[] bytes() {
            return Bytes.of(opcode(), RATES.indexOf(bitsPerSecond));
        }
    }

    /**
     * Sets when the robot cleans by itself, once a week on each of the days.
     *
     * @param times to the minute; empty switches the schedule off
     */
    record Schedule(Map<DayOfWeek, LocalTime> times) implements Command {

        public Schedule {
            times = Map.copyOf(times);
            times.forEach((day, time) -> requireWholeMinute(day + "'s time", time));
        }

        @Override
        public byte[] bytes() {
            int[] data = new int[15];
            times.forEach((day, time) -> {
                int number = numberOf(day);
                data[0] |= 1 << number;
                data[1 + 2 * number] = time.getHour();
                data[2 + 2 * number] = time.getMinute();
            });
            return Bytes.of(opcode(), data);
        }
    }

    /**
     * Sets the robot's clock.
     *
     * @param time to the minute
     */
    record SetDayTime(DayOfWeek day, LocalTime time) implements Command {

        public SetDayTime {
            requireWholeMinute("time", time);
        }

        @Override
        public byte[] bytes() {
            return Bytes.of(opcode(), numberOf(day), time.getHour(), time.getMinute());
        }
    }

    private static int numberOf(DayOfWeek day) {
        // The robot's week starts with Sunday as 0.
        return day.getValue() % 7;
    }

    private static void requireWholeMinute(String field, LocalTime time) {
        if (!time.equals(time.truncatedTo(ChronoUnit.MINUTES))) {
            throw new IllegalArgumentException(field + " is " + time + "; allowed are whole minutes");
        }
    }
}
