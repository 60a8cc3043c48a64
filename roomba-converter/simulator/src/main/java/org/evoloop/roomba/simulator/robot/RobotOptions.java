package org.evoloop.roomba.simulator.robot;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.FirmwareVersion;
import org.evoloop.roomba.oi.StreamFrame.Checksum;
import org.evoloop.roomba.simulator.room.Room;

/**
 * The options of a simulated robot: its room and its faults. {@link #builder()} starts with a robot without faults on
 * an open plain.
 *
 * <p>Threading: immutable; the builder is not thread-safe.
 *
 * @since 0.1
 */
public final class RobotOptions {
    /** In less time the robot could not drive half a metre and back. */
    public static final int SHORTEST_SPOT_MILLIS = 8_000;

    /** Ten minutes. */
    public static final int LONGEST_SPOT_MILLIS = 600_000;

    private static final double LARGEST_SHARE = 0.5;

    private final Room room;
    private final int spotDurationMillis;
    private final int batteryPercent;
    private final int baud;
    private final FirmwareVersion firmware;
    private final Checksum checksum;
    private final int modeOffset;
    private final boolean noise;
    private final double dropShare;
    private final double corruptShare;
    private final long seed;
    private final boolean sleepy;
    private final boolean strictModeWindow;

    private RobotOptions(Builder wanted) {
        room = wanted.room;
        spotDurationMillis = wanted.spotDurationMillis;
        batteryPercent = wanted.batteryPercent;
        baud = wanted.baud;
        firmware = wanted.firmware;
        checksum = wanted.checksum;
        modeOffset = wanted.modeOffset;
        noise = wanted.noise;
        dropShare = wanted.dropShare;
        corruptShare = wanted.corruptShare;
        seed = wanted.seed;
        sleepy = wanted.sleepy;
        strictModeWindow = wanted.strictModeWindow;
        List<String> problems = new ArrayList<>();
        require(
                spotDurationMillis >= SHORTEST_SPOT_MILLIS && spotDurationMillis <= LONGEST_SPOT_MILLIS,
                "spot duration is " + spotDurationMillis + " ms; allowed is " + SHORTEST_SPOT_MILLIS + " to "
                        + LONGEST_SPOT_MILLIS + " ms",
                problems);
        require(
                batteryPercent >= 1 && batteryPercent <= 100,
                "battery is " + batteryPercent + " %; allowed is 1 to 100 %",
                problems);
        require(
                Command.Baud.RATES.contains(baud),
                "baud is " + baud + "; allowed is one of " + Command.Baud.RATES,
                problems);
        require(modeOffset == 0 || modeOffset == 1, "mode offset is " + modeOffset + "; allowed is 0 or 1", problems);
        requireShare("drop", dropShare, problems);
        requireShare("corrupt", corruptShare, problems);
        if (!problems.isEmpty()) {
            throw new IllegalArgumentException(String.join("\n", problems));
        }
    }

    private static void require(boolean holds, String problem, List<String> problems) {
        if (!holds) {
            problems.add(problem);
        }
    }

    private static void requireShare(String name, double share, List<String> problems) {
        require(
                share >= 0 && share <= LARGEST_SHARE,
                name + " is " + share + "; allowed is 0 to " + LARGEST_SHARE,
                problems);
    }

    /** A robot without faults on an open plain. */
    public static RobotOptions defaults() {
        return builder().build();
    }

    /** A builder that starts with a robot without faults on an open plain. */
    public static Builder builder() {
        return new Builder();
    }

    /** The robot's room; the robot starts at the room's start. */
    public Room room() {
        return room;
    }

    /**
     * The duration of spot cleaning, {@value #SHORTEST_SPOT_MILLIS} to {@value #LONGEST_SPOT_MILLIS}; iRobot does not
     * document the real one.
     */
    public int spotDurationMillis() {
        return spotDurationMillis;
    }

    /** The battery's initial charge, 1 to 100. */
    public int batteryPercent() {
        return batteryPercent;
    }

    /** The line's rate after power-on, one of {@link Command.Baud#RATES}. */
    public int baud() {
        return baud;
    }

    /** The version in the boot text; old versions report wrong distances (before 3.3.0) and angles (up to 3.4.0). */
    public FirmwareVersion firmware() {
        return firmware;
    }

    /** How the checksum of stream frames is computed; real robots include the header. */
    public Checksum checksum() {
        return checksum;
    }

    /** How much packet 35 is too high, 0 or 1, as with some robots with Wi-Fi. */
    public int modeOffset() {
        return modeOffset;
    }

    /** Whether stray bytes occur between replies and frames. */
    public boolean noise() {
        return noise;
    }

    /** The part of all bytes, to and from the robot, that is lost, 0 to 0.5. */
    public double dropShare() {
        return dropShare;
    }

    /** The part of all bytes, to and from the robot, that is changed, 0 to 0.5. */
    public double corruptShare() {
        return corruptShare;
    }

    /** The seed that selects these bytes; the same seed selects the same bytes. */
    public long seed() {
        return seed;
    }

    /** Whether the wake line is not connected, so that only its CLEAN button wakes the robot. */
    public boolean sleepy() {
        return sleepy;
    }

    /** Whether commands sent too soon after a mode change are ignored. */
    public boolean strictModeWindow() {
        return strictModeWindow;
    }

    /** Collects options; each method sets the option of the same name. */
    public static final class Builder {
        private Room room = Room.OPEN;
        private int spotDurationMillis = 45_000;
        private int batteryPercent = 100;
        private int baud = 115_200;
        private FirmwareVersion firmware = new FirmwareVersion(3, 7, 7);
        private Checksum checksum = Checksum.WITH_HEADER;
        private int modeOffset;
        private boolean noise;
        private double dropShare;
        private double corruptShare;
        private long seed = 1;
        private boolean sleepy;
        private boolean strictModeWindow;

        private Builder() {}

        /** Sets {@link RobotOptions#room()}. */
        public Builder room(Room value) {
            room = value;
            return this;
        }

        /** Sets {@link RobotOptions#spotDurationMillis()}. */
        public Builder spotDurationMillis(int value) {
            spotDurationMillis = value;
            return this;
        }

        /** Sets {@link RobotOptions#batteryPercent()}. */
        public Builder batteryPercent(int value) {
            batteryPercent = value;
            return this;
        }

        /** Sets {@link RobotOptions#baud()}. */
        public Builder baud(int value) {
            baud = value;
            return this;
        }

        /** Sets {@link RobotOptions#firmware()}. */
        public Builder firmware(FirmwareVersion value) {
            firmware = value;
            return this;
        }

        /** Sets {@link RobotOptions#checksum()}. */
        public Builder checksum(Checksum value) {
            checksum = value;
            return this;
        }

        /** Sets {@link RobotOptions#modeOffset()}. */
        public Builder modeOffset(int value) {
            modeOffset = value;
            return this;
        }

        /** Sets {@link RobotOptions#noise()}. */
        public Builder noise(boolean value) {
            noise = value;
            return this;
        }

        /** Sets {@link RobotOptions#dropShare()}. */
        public Builder dropShare(double value) {
            dropShare = value;
            return this;
        }

        /** Sets {@link RobotOptions#corruptShare()}. */
        public Builder corruptShare(double value) {
            corruptShare = value;
            return this;
        }

        /** Sets {@link RobotOptions#seed()}. */
        public Builder seed(long value) {
            seed = value;
            return this;
        }

        /** Sets {@link RobotOptions#sleepy()}. */
        public Builder sleepy(boolean value) {
            sleepy = value;
            return this;
        }

        /** Sets {@link RobotOptions#strictModeWindow()}. */
        public Builder strictModeWindow(boolean value) {
            strictModeWindow = value;
            return this;
        }

        /**
         * The options.
         *
         * @throws IllegalArgumentException with one line for each value out of range, naming the value and the range
         */
        public RobotOptions build() {
            return new RobotOptions(this);
        }
    }
}
