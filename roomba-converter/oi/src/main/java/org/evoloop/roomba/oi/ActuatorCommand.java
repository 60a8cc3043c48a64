package org.evoloop.roomba.oi;

import java.util.List;
import java.util.Set;

/**
 * A command to wheels, motors, lights, buttons and speaker (specification, "Actuator Commands"). Velocities are those
 * of the wheels on the floor; positive is forward.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface ActuatorCommand extends Command {
    /** The highest speed of a wheel on the floor. */
    int FASTEST_MM_PER_S = 500;

    /**
     * Drives along a circle.
     *
     * @param velocityMmPerS -500 to 500, of the robot's centre
     * @param radiusMm -2000 to 2000, from the turning circle's centre to the robot's; positive turns left. 1 and -1
     *     spin in place; 32767 and -32768 drive straight
     */
    record Drive(int velocityMmPerS, int radiusMm) implements ActuatorCommand {
        /** The radius of a straight line; -32768 has the same effect. */
        public static final int STRAIGHT = 32767;

        /** The radius that spins in place, to the left. */
        public static final int SPIN_COUNTERCLOCKWISE = 1;
        /** The radius that spins in place, to the right. */
        public static final int SPIN_CLOCKWISE = -1;

        private static final int WIDEST_RADIUS = 2000;

        public Drive {
            requireVelocity("velocityMmPerS", velocityMmPerS);
            if (radiusMm != STRAIGHT && radiusMm != Short.MIN_VALUE) {
                Bytes.requireRange(
                        "radiusMm", radiusMm, -WIDEST_RADIUS, WIDEST_RADIUS, "mm (or 32767 or -32768 for straight)");
            }
        }

        /** What is asked for, each number no farther than it may be. */
        static Drive nearest(int velocityMmPerS, int radiusMm) {
            boolean straight = radiusMm == STRAIGHT || radiusMm == Short.MIN_VALUE;
            return new Drive(
                    clamp(velocityMmPerS, FASTEST_MM_PER_S), straight ? radiusMm : clamp(radiusMm, WIDEST_RADIUS));
        }

        @Override
        public byte[] bytes() {
            return Bytes.of(opcode(), Bytes.high(velocityMmPerS), velocityMmPerS, Bytes.high(radiusMm), radiusMm);
        }
    }

    /** Drives each wheel at a velocity of its own, -500 to 500 mm/s; the right wheel comes first, as on the wire. */
    record DriveDirect(int rightMmPerS, int leftMmPerS) implements ActuatorCommand {

        public DriveDirect {
            requireVelocity("rightMmPerS", rightMmPerS);
            requireVelocity("leftMmPerS", leftMmPerS);
        }

        /** What is asked for, each number no farther than it may be. */
        static DriveDirect nearest(int rightMmPerS, int leftMmPerS) {
            return new DriveDirect(clamp(rightMmPerS, FASTEST_MM_PER_S), clamp(leftMmPerS, FASTEST_MM_PER_S));
        }

        @Override
        public byte[] bytes() {
            return Bytes.of(opcode(), Bytes.high(rightMmPerS), rightMmPerS, Bytes.high(leftMmPerS), leftMmPerS);
        }
    }

    /** Powers each wheel's motor, -255 (full backward) to 255; the right wheel comes first, as on the wire. */
    record DrivePwm(int rightPwm, int leftPwm) implements ActuatorCommand {
        private static final int FULL_PWM = 255;

        public DrivePwm {
            Bytes.requireRange("rightPwm", rightPwm, -FULL_PWM, FULL_PWM, "of 255");
            Bytes.requireRange("leftPwm", leftPwm, -FULL_PWM, FULL_PWM, "of 255");
        }

        /** What is asked for, each number no farther than it may be. */
        static DrivePwm nearest(int rightPwm, int leftPwm) {
            return new DrivePwm(clamp(rightPwm, FULL_PWM), clamp(leftPwm, FULL_PWM));
        }

        @Override
        public byte[] bytes() {
            return Bytes.of(opcode(), Bytes.high(rightPwm), rightPwm, Bytes.high(leftPwm), leftPwm);
        }
    }

    /**
     * Switches the cleaning motors on at full power, or off.
     *
     * @param bits a sum of the constants, 0 to 31
     */
    record Motors(int bits) implements ActuatorCommand {
        /** The side brush is on. */
        public static final int SIDE_BRUSH = 1;
        /** The vacuum is on. */
        public static final int VACUUM = 2;
        /** The main brush is on. */
        public static final int MAIN_BRUSH = 4;
        /** The side brush turns clockwise, not counterclockwise. */
        public static final int SIDE_BRUSH_CLOCKWISE = 8;
        /** The main brush turns outward, not inward. */
        public static final int MAIN_BRUSH_OUTWARD = 16;

        public Motors {
            Bytes.requireRange("bits", bits, 0, 31, "");
        }

        @Override
        public byte[] bytes() {
            return Bytes.of(opcode(), bits);
        }
    }

    /**
     * Powers the cleaning motors in steps of 1/127.
     *
     * @param mainBrushPwm -127 (full, outward) to 127
     * @param sideBrushPwm -127 (full, clockwise) to 127
     * @param vacuumPwm 0 to 127
     */
    record PwmMotors(int mainBrushPwm, int sideBrushPwm, int vacuumPwm) implements ActuatorCommand {

        public PwmMotors {
            Bytes.requireRange("mainBrushPwm", mainBrushPwm, -127, 127, "of 127");
            Bytes.requireRange("sideBrushPwm", sideBrushPwm, -127, 127, "of 127");
            Bytes.requireRange("vacuumPwm", vacuumPwm, 0, 127, "of 127");
        }

        @Override
        public byte[] bytes() {
            return Bytes.of(opcode(), mainBrushPwm, sideBrushPwm, vacuumPwm);
        }
    }

    /**
     * Sets the lights.
     *
     * @param bits a sum of the constants, 0 to 15
     * @param powerColor of the Clean button, 0 (green) to 255 (red)
     * @param powerIntensity of the Clean button, 0 (dark) to 255
     */
    record Leds(int bits, int powerColor, int powerIntensity) implements ActuatorCommand {
        /** The light for dirt is on. */
        public static final int DEBRIS = 1;
        /** The Spot button's light is on. */
        public static final int SPOT = 2;
        /** The Dock button's light is on. */
        public static final int DOCK = 4;
        /** The light that asks for help is on. */
        public static final int CHECK_ROBOT = 8;

        public Leds {
            Bytes.requireRange("bits", bits, 0, 15, "");
            Bytes.requireRange("powerColor", powerColor, 0, 255, "");
            Bytes.requireRange("powerIntensity", powerIntensity, 0, 255, "");
        }

        @Override
        public byte[] bytes() {
            return Bytes.of(opcode(), bits, powerColor, powerIntensity);
        }
    }

    /**
     * Sets the lights around the clock of robots that have one.
     *
     * @param weekdayBits bit 0 is Sunday, bit 6 is Saturday
     * @param scheduleBits a sum of the constants, 0 to 31
     */
    record SchedulingLeds(int weekdayBits, int scheduleBits) implements ActuatorCommand {
        /** The colon of the clock. */
        public static final int COLON = 1;
        /** The light PM. */
        public static final int PM = 2;
        /** The light AM. */
        public static final int AM = 4;
        /** The Clock button's light. */
        public static final int CLOCK = 8;
        /** The Schedule button's light. */
        public static final int SCHEDULE = 16;

        public SchedulingLeds {
            Bytes.requireRange("weekdayBits", weekdayBits, 0, 127, "");
            Bytes.requireRange("scheduleBits", scheduleBits, 0, 31, "");
        }

        @Override
        public byte[] bytes() {
            return Bytes.of(opcode(), weekdayBits, scheduleBits);
        }
    }

    /**
     * Sets single segments of the clock's digits; bits 0 to 6 are the segments A to G. The specification says that the
     * firmware of its time does not obey this command.
     *
     * @param digit3 the leftmost digit, 0 to 127 like the others
     */
    record DigitLedsRaw(int digit3, int digit2, int digit1, int digit0) implements ActuatorCommand {

        public DigitLedsRaw {
            Bytes.requireRange("digit3", digit3, 0, 127, "");
            Bytes.requireRange("digit2", digit2, 0, 127, "");
            Bytes.requireRange("digit1", digit1, 0, 127, "");
            Bytes.requireRange("digit0", digit0, 0, 127, "");
        }

        @Override
        public byte[] bytes() {
            return Bytes.of(opcode(), digit3, digit2, digit1, digit0);
        }
    }

    /**
     * Shows a text on the clock's digits.
     *
     * @param text four printable ASCII characters
     */
    record DigitLedsAscii(String text) implements ActuatorCommand {

        public DigitLedsAscii {
            Bytes.requireRange("length of text", text.length(), 4, 4, "characters");
            text.chars().forEach(character -> Bytes.requireRange("character of text", character, 32, 126, ""));
        }

        @Override
        public byte[] bytes() {
            return Bytes.of(opcode(), text.chars().toArray());
        }
    }

    /** Presses buttons; the robot releases them after 1/6 s. */
    record Buttons(Set<Button> pressed) implements ActuatorCommand {

        public Buttons {
            pressed = Set.copyOf(pressed);
        }

        @Override
        public byte[] bytes() {
            return Bytes.of(opcode(), Button.toBits(pressed));
        }
    }

    /**
     * Stores a song under a number.
     *
     * @param number 0 to 4
     * @param notes 1 to 255; the specification allows {@value #NOTES_PER_SONG}; with more, robots overwrite the songs
     *     that follow
     */
    record Song(int number, List<Note> notes) implements ActuatorCommand {
        /** The number of songs that a robot stores. */
        public static final int SONGS = 5;

        /** The number of notes that a robot stores for each song. */
        public static final int NOTES_PER_SONG = 16;

        /**
         * One tone or rest.
         *
         * @param pitch as in MIDI, 31 to 127; any other byte is a rest
         * @param durationIn64thsOfSecond 0 to 255
         */
        public record Note(int pitch, int durationIn64thsOfSecond) {
            public Note {
                Bytes.requireRange("pitch", pitch, 0, 255, "");
                Bytes.requireRange("durationIn64thsOfSecond", durationIn64thsOfSecond, 0, 255, "/64 s");
            }
        }

        public Song {
            Bytes.requireRange("song number", number, 0, SONGS - 1, "");
            notes = List.copyOf(notes);
            Bytes.requireRange("number of notes", notes.size(), 1, 255, "");
        }

        @Override
        public byte[] bytes() {
            int[] data = new int[2 + 2 * notes.size()];
            data[0] = number;
            data[1] = notes.size();
            for (int i = 0; i < notes.size(); i++) {
                data[2 + 2 * i] = notes.get(i).pitch();
                data[3 + 2 * i] = notes.get(i).durationIn64thsOfSecond();
            }
            return Bytes.of(opcode(), data);
        }
    }

    /** Plays the song with this number, 0 to 4, if it was stored. */
    record Play(int song) implements ActuatorCommand {

        public Play {
            Bytes.requireRange("song number", song, 0, 4, "");
        }

        @Override
        public byte[] bytes() {
            return Bytes.of(opcode(), song);
        }
    }

    private static void requireVelocity(String field, int velocityMmPerS) {
        Bytes.requireRange(field, velocityMmPerS, -FASTEST_MM_PER_S, FASTEST_MM_PER_S, "mm/s");
    }

    private static int clamp(int value, int farthest) {
        return Math.max(-farthest, Math.min(farthest, value));
    }
}
