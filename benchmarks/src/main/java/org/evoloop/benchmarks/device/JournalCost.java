package org.evoloop.benchmarks.device;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.HdrHistogram.Histogram;
import org.evoloop.benchmarks.report.Figures;
import org.evoloop.benchmarks.report.Latencies;
import org.evoloop.benchmarks.report.Row;
import org.evoloop.benchmarks.report.TemporaryFolder;
import org.evoloop.benchmarks.running.PaperModels;
import org.evoloop.evolution.ModelPair;
import org.evoloop.journal.Forcing;
import org.evoloop.journal.Journal;
import org.evoloop.link.SerialLink;
import org.evoloop.link.SerialSettings;
import org.evoloop.loop.LoopConfig;
import org.evoloop.roomba.RobotModels;
import org.evoloop.roomba.RoombaConverter;
import org.evoloop.roomba.RoombaOptions;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.roomba.session.SessionOptions;
import org.evoloop.roomba.simulator.SimulatorServer;
import org.evoloop.roomba.simulator.WorldCommands;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.jspecify.annotations.Nullable;

/**
 * What a journal adds to a button press: the measurement of {@link PressToCommand} without a journal, with one forced
 * per batch, and with one forced per intent. They alternate every {@value #TURN} presses in one process, so that other
 * load on the computer affects all three.
 */
public final class JournalCost {
    private static final double SPEED = 4;
    private static final int TURN = 10;

    /** The kinds of journal. */
    enum Keeping {
        NONE(null),
        BY_BATCH(Forcing.BY_BATCH),
        PER_INTENT(Forcing.PER_INTENT);

        private final @Nullable Forcing forcing;

        Keeping(@Nullable Forcing forcing) {
            this.forcing = forcing;
        }

        @Nullable
        Journal in(Path directory) {
            return forcing == null ? null : Journal.in(directory).withForcing(forcing);
        }
    }

    private JournalCost() {}

    /**
     * Prints the medians and the 99th percentiles in microseconds.
     *
     * @param arguments the minimum number of commands of each kind
     */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        int wanted = Integer.parseInt(arguments[0]);
        Map<Keeping, Histogram> nanos = new EnumMap<>(Keeping.class);
        try (TemporaryFolder folder = TemporaryFolder.create();
                Clock robotClock = new SystemClock();
                SimulatorServer robot = SimulatorServer.start(
                        folder.path().resolve("roomba"), RobotOptions.defaults(), robotClock, SPEED)) {
            // Warm-up, not counted.
            for (Keeping keeping : Keeping.values()) {
                turn(keeping, folder.path(), robot, Latencies.histogram());
                nanos.put(keeping, Latencies.histogram());
            }
            while (nanos.values().stream().anyMatch(each -> each.getTotalCount() < wanted)) {
                for (Map.Entry<Keeping, Histogram> each : nanos.entrySet()) {
                    turn(each.getKey(), folder.path(), robot, each.getValue());
                }
            }
        }
        nanos.forEach((keeping, each) -> Latencies.print(keeping.name(), each));
    }

    private static void turn(Keeping keeping, Path folder, SimulatorServer robot, Histogram nanos)
            throws IOException, InterruptedException {
        var device = PaperModels.cleaningRobot().original();
        try (Clock clock = new SystemClock(SPEED);
                RoombaConverter roomba = RoombaConverter.connect(
                        baud -> new TimedLink(
                                SerialLink.open(new SerialSettings(robot.path().toString()).withBaud(baud)), nanos),
                        LoopConfig.defaults("roomba", clock),
                        SessionOptions.defaults().withSilenceLimit(Duration.ofSeconds(8)),
                        RoombaOptions.of(
                                        RobotModels.of(new ModelPair(device, device)),
                                        time -> StartPointSensor.byWheels(1000, 500))
                                .withJournal(keeping.in(Files.createTempDirectory(folder, "journal"))))) {
            roomba.converter().start();
            for (int press = 0; press < TURN; press++) {
                PressToCommand.press(new WorldCommands(robot), roomba, clock);
            }
        }
    }

    /** The rows of the table. */
    static List<Row> rows(Figures measured) {
        double without = measured.get("NONE p50");
        return List.of(
                new Row(
                        "button to command with a journal by batch, median",
                        "us",
                        measured.get("BY_BATCH p50"),
                        Row.Goal.atMostTimes(1.1, "without a journal", without)),
                new Row(
                        "button to command with a journal per intent, median",
                        "us",
                        measured.get("PER_INTENT p50"),
                        Row.Goal.atMostTimes(50, "without a journal", without)));
    }
}
