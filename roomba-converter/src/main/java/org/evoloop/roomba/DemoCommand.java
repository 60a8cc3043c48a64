package org.evoloop.roomba;

import java.io.IOException;
import java.io.PrintWriter;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.Callable;
import org.evoloop.evolution.ModelPair;
import org.evoloop.roomba.move.MoveOptions;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.evoloop.xmi.ModelFiles;
import org.evoloop.xmi.XmiFile;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Plays the scenarios with a simulated robot; prints their transcripts, and checks where the robot truly ends. */
@Command(
        name = "demo",
        description = "Plays scenarios with a simulated Roomba and prints their transcripts.",
        mixinStandardHelpOptions = true)
final class DemoCommand implements Callable<Integer> {
    @Option(
            names = "--scenario",
            paramLabel = "NAME",
            description = "Only this one: remote-start, spot-from-clean, own-button or timeout (default: all four).")
    private @Nullable String scenario;

    @Option(
            names = "--speed",
            paramLabel = "N",
            defaultValue = "10",
            description = "How many times faster than real time robot and converter live (default: ${DEFAULT-VALUE}).")
    private double speed;

    @Option(
            names = "--two-processes",
            description = "Runs the simulated robot in a process of its own, joined by nothing but its serial port.")
    private boolean twoProcesses;

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException, InterruptedException {
        PrintWriter err = spec.commandLine().getErr();
        RoombaCommand.requireSpeed(speed);
        String only = scenario;
        List<Scenario> wanted = only == null ? List.of(Scenario.values()) : List.of(Scenario.of(only));
        int failed = 0;
        for (Scenario next : wanted) {
            if (only == null) {
                System.out.println("=== scenario: " + next);
            }
            try {
                play(next);
                err.println("evoloop: " + next + " ended where it should, by the simulated robot's true state");
            } catch (Play.Unfulfilled broken) {
                failed++;
                err.println("evoloop: " + next + " failed: " + broken.getMessage());
            }
            err.flush();
        }
        return failed == 0 ? CommandLine.ExitCode.OK : CommandLine.ExitCode.SOFTWARE;
    }

    private void play(Scenario next) throws IOException, InterruptedException, Play.Unfulfilled {
        XmiFile file = XmiFile.read(ModelFiles.find("models/cleaning-robot.xml", DemoCommand.class));
        RoombaConverter.Options options = new RoombaConverter.Options(
                new ModelPair(file.pick("original"), file.pick("new")),
                StartPointSensor.byWheels(Scenario.START_X_MM, Scenario.START_Y_MM),
                MoveOptions.defaults().atPace(speed),
                Duration.ofSeconds(5));
        try (Clock clock = new SystemClock(speed);
                SimulatedWorld world =
                        twoProcesses ? SimulatedWorld.inAnotherProcess(speed) : SimulatedWorld.inThisProcess(speed);
                RoombaConverter roomba = RoombaConverter.connect(
                        RoombaCommand.cable(world.port().toString()),
                        RoombaCommand.config(clock, speed),
                        RoombaCommand.sessionOptions(speed),
                        options)) {
            roomba.converter().start();
            next.play(new Play(roomba, world, clock));
        }
    }
}
