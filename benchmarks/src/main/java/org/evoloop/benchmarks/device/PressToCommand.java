package org.evoloop.benchmarks.device;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.EnumMap;
import java.util.Map;
import org.HdrHistogram.Histogram;
import org.evoloop.benchmarks.report.Latencies;
import org.evoloop.benchmarks.report.TemporaryFolder;
import org.evoloop.roomba.simulator.SimulatorServer;
import org.evoloop.roomba.simulator.WorldCommands;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;

/**
 * The time from a press of the robot's own CLEAN button to the command that answers it, in every {@link PressWay}. They
 * take turns of {@value #TURN} presses in one process at one simulated robot, so that other load and the state of the
 * processors' caches affect all of them.
 */
public final class PressToCommand {
    /** Commands and actions of its own take the robot a moment. */
    static final Duration REST = Duration.ofMillis(600);

    private static final double SPEED = 1;
    private static final int TURN = 10;
    private static final Duration LOOK = Duration.ofMillis(10);

    private PressToCommand() {}

    /**
     * Prints the medians and the 99th percentiles in microseconds, and what a {@link PageProbe} found.
     *
     * @param arguments the minimum number of commands that are counted of each way
     */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        int wanted = Integer.parseInt(arguments[0]);
        Map<PressWay, Histogram> nanos = new EnumMap<>(PressWay.class);
        PageProbe pages = new PageProbe();
        try (TemporaryFolder folder = TemporaryFolder.create();
                Clock clock = new SystemClock(SPEED);
                Clock robotClock = new SystemClock();
                SimulatorServer robot = SimulatorServer.start(
                        folder.path().resolve("roomba"), RobotOptions.defaults(), robotClock, SPEED)) {
            // The first turns, in which code is loaded and compiled, are not counted.
            for (PressWay way : PressWay.values()) {
                turn(way, robot, folder.path(), clock, Latencies.histogram(), pages);
                nanos.put(way, Latencies.histogram());
            }
            while (nanos.values().stream().anyMatch(each -> each.getTotalCount() < wanted)) {
                for (Map.Entry<PressWay, Histogram> each : nanos.entrySet()) {
                    turn(each.getKey(), robot, folder.path(), clock, each.getValue(), pages);
                }
            }
        }
        nanos.forEach((way, each) -> Latencies.print(way.name(), each));
        System.out.println("slow pages " + pages.slowPercent());
    }

    private static void turn(
            PressWay way, SimulatorServer robot, Path folder, Clock clock, Histogram nanos, PageProbe pages)
            throws IOException, InterruptedException {
        WorldCommands world = new WorldCommands(robot);
        try (Answerer answerer = way.open(robot.path(), folder, clock, nanos)) {
            for (int press = 0; press < TURN; press++) {
                long before = answerer.answered();
                world.execute("press clean");
                while (answerer.answered() == before) {
                    clock.sleep(LOOK);
                }
                pages.touch();
                clock.sleep(REST);
            }
        }
    }
}
