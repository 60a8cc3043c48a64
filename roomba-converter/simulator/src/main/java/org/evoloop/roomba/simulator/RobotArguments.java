package org.evoloop.roomba.simulator;

import org.evoloop.roomba.oi.FirmwareVersion;
import org.evoloop.roomba.oi.StreamFrame.Checksum;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.roomba.simulator.room.Room;
import org.evoloop.roomba.simulator.room.RoomFile;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;

/** The command line options for {@link RobotOptions}, which checks the values. */
final class RobotArguments {
    private static final double MILLIS_PER_SECOND = 1000;

    @Option(
            names = "--room",
            paramLabel = "FILE",
            description = "The room it lives in, described below, or living-room, which is included (default: an open "
                    + "plain).")
    private @Nullable String room;

    @Option(
            names = "--spot-duration",
            paramLabel = "SECONDS",
            defaultValue = "45",
            description = "How long spot cleaning lasts in robot time (default: ${DEFAULT-VALUE}).")
    private double spotDurationSeconds;

    @Option(
            names = "--battery",
            paramLabel = "PERCENT",
            defaultValue = "100",
            description = "How full the battery is at first (default: ${DEFAULT-VALUE}).")
    private int batteryPercent;

    @Option(
            names = "--baud",
            paramLabel = "RATE",
            defaultValue = "115200",
            description = "The robot's rate after power-on; a client with another rate receives and sends garbage "
                    + "(default: ${DEFAULT-VALUE}).")
    private int baud;

    @Option(
            names = "--firmware",
            paramLabel = "VERSION",
            defaultValue = "3.7.7",
            converter = FirmwareConverter.class,
            description = "The version in its boot text; distances are wrong before 3.3.0, angles up to 3.4.0 "
                    + "(default: ${DEFAULT-VALUE}).")
    private FirmwareVersion firmware = new FirmwareVersion(0, 0, 0);

    @Option(
            names = "--checksum",
            paramLabel = "real|spec500",
            defaultValue = "real",
            converter = ChecksumConverter.class,
            description = "Of stream frames: as robots send it, or as the Roomba 500's specification has it.")
    private Checksum checksum = Checksum.WITH_HEADER;

    @Option(
            names = "--mode-offset",
            paramLabel = "N",
            defaultValue = "0",
            description = "What packet 35 reports too much, 0 or 1 (default: ${DEFAULT-VALUE}).")
    private int modeOffset;

    @Option(names = "--noise", description = "Sends stray bytes between replies and frames.")
    private boolean noise;

    @Option(
            names = "--drop",
            paramLabel = "P",
            defaultValue = "0",
            description = "Drops this share of all bytes in both directions, 0 to 0.5 (default: ${DEFAULT-VALUE}).")
    private double dropShare;

    @Option(
            names = "--corrupt",
            paramLabel = "P",
            defaultValue = "0",
            description = "Changes this share of all bytes in both directions, 0 to 0.5 (default: ${DEFAULT-VALUE}).")
    private double corruptShare;

    @Option(
            names = "--seed",
            paramLabel = "N",
            defaultValue = "1",
            description = "The random seed of --noise, --drop and --corrupt (default: ${DEFAULT-VALUE}).")
    private long seed;

    @Option(
            names = "--sleepy",
            description = "Only its CLEAN button and the dock wake a sleeping robot (default: opening the port, too).")
    private boolean sleepy;

    @Option(
            names = "--strict-mode-window",
            description = "Ignores commands for 20 ms of robot time after one that changes the mode.")
    private boolean strictModeWindow;

    /**
     * The options.
     *
     * @throws IllegalArgumentException with a line for each invalid option
     */
    RobotOptions toOptions() {
        return RobotOptions.builder()
                .room(room())
                .spotDurationMillis((int) Math.round(spotDurationSeconds * MILLIS_PER_SECOND))
                .batteryPercent(batteryPercent)
                .baud(baud)
                .firmware(firmware)
                .checksum(checksum)
                .modeOffset(modeOffset)
                .noise(noise)
                .dropShare(dropShare)
                .corruptShare(corruptShare)
                .seed(seed)
                .sleepy(sleepy)
                .strictModeWindow(strictModeWindow)
                .build();
    }

    private Room room() {
        return room == null ? Room.OPEN : RoomFile.named(room);
    }

    /** Made by picocli. */
    static final class FirmwareConverter implements ITypeConverter<FirmwareVersion> {
        @Override
        public FirmwareVersion convert(String text) {
            try {
                return FirmwareVersion.parse(text);
            } catch (IllegalArgumentException mistake) {
                throw new TypeConversionException(mistake.getMessage());
            }
        }
    }

    /** Made by picocli. */
    static final class ChecksumConverter implements ITypeConverter<Checksum> {
        @Override
        public Checksum convert(String text) {
            return switch (text) {
                case "real" -> Checksum.WITH_HEADER;
                case "spec500" -> Checksum.WITHOUT_HEADER;
                default -> throw new TypeConversionException("'" + text + "' is unknown; there are real and spec500");
            };
        }
    }
}
