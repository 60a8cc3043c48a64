package org.evoloop.benchmarks.device;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import org.HdrHistogram.Histogram;
import org.evoloop.benchmarks.report.Latencies;
import org.evoloop.benchmarks.running.PaperModels;
import org.evoloop.evolution.ModelPair;
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

/**
 * Presses the robot's own CLEAN button repeatedly. When the robot is idle and on, it only reports the press, and the
 * converter sends the command; when it is cleaning, it pauses by itself. Both models are the device's own, so that
 * nothing else adds to the latency.
 */
public final class PressToCommand {
    private static final double SPEED = 4;
    private static final Duration LOOK = Duration.ofMillis(50);

    private PressToCommand() {}

    /**
     * Prints the median and the 99th percentile in microseconds.
     *
     * @param arguments the number of commands, and the name of the {@link PressWay}
     */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        int wanted = Integer.parseInt(arguments[0]);
        PressWay way = PressWay.valueOf(arguments[1]);
        var device = PaperModels.cleaningRobot().original();
        Histogram nanos = Latencies.histogram();
        Path folder = Files.createTempDirectory("evoloop");
        Path port = folder.resolve("roomba");
        try (Clock clock = new SystemClock(SPEED);
                Clock robotClock = new SystemClock();
                SimulatorServer robot = SimulatorServer.start(port, RobotOptions.defaults(), robotClock, SPEED);
                RoombaConverter roomba = RoombaConverter.connect(
                        baud -> new TimedLink(
                                SerialLink.open(new SerialSettings(port.toString()).withBaud(baud)), nanos),
                        way.configured(LoopConfig.defaults("roomba", clock)),
                        SessionOptions.defaults().withSilenceLimit(Duration.ofSeconds(8)),
                        RoombaOptions.of(
                                RobotModels.of(new ModelPair(device, device)),
                                time -> StartPointSensor.byWheels(1000, 500)))) {
            roomba.converter().start();
            WorldCommands world = new WorldCommands(robot);
            while (nanos.getTotalCount() < wanted) {
                press(world, roomba, clock);
            }
        } finally {
            Files.deleteIfExists(port);
            Files.delete(folder);
        }
        Latencies.print("press", nanos);
    }

    /** Presses once, and waits until the press has been handled. */
    static void press(WorldCommands world, RoombaConverter roomba, Clock clock) throws InterruptedException {
        long before = roomba.converter().status().events().handled();
        world.execute("press clean");
        while (roomba.converter().status().events().handled() == before) {
            clock.sleep(LOOK);
        }
        // Commands and actions of its own take the robot a moment.
        clock.sleep(Duration.ofSeconds(2));
    }
}
