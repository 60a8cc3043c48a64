package org.evoloop.roomba;

import java.io.IOException;
import java.io.PrintWriter;
import java.net.URI;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.function.Function;
import org.evoloop.evolution.ModelPair;
import org.evoloop.roomba.camera.CameraException;
import org.evoloop.roomba.camera.CameraSource;
import org.evoloop.roomba.camera.live.CameraSettings;
import org.evoloop.roomba.camera.vision.OpenCv;
import org.evoloop.roomba.move.MoveOptions;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.evoloop.xmi.ModelFile;
import org.evoloop.xmi.ModelFiles;
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
    private static final double FASTEST_WITH_CAMERA = 4;

    /** Linux may hold back the bytes of a pseudo-terminal for two seconds if its processors are overloaded. */
    private static final int TIMES_USUAL_SILENCE = 5;

    @Option(
            names = "--scenario",
            paramLabel = "NAME",
            description =
                    "Only this one: remote-start, spot-from-clean, own-button, timeout or evolve (default: all five).")
    private @Nullable String scenario;

    @Option(
            names = "--speed",
            paramLabel = "N",
            defaultValue = "10",
            description = "How many times faster than real time robot and converter run (default: ${DEFAULT-VALUE}); "
                    + "at most 4 with the camera.")
    private double speed;

    @Option(
            names = "--two-processes",
            description = "Runs the simulated robot in a process of its own, connected only by its serial port.")
    private boolean twoProcesses;

    @Option(
            names = "--svg",
            paramLabel = "FILE",
            description = "With one --scenario: draws the room, the marker, the robot's way and what its camera sees.")
    private @Nullable Path svg;

    @Option(
            names = "--record",
            paramLabel = "FILE.avi",
            description = "With --scenario remote-start: records what the camera sees and finds.")
    private @Nullable Path record;

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException, InterruptedException {
        PrintWriter err = spec.commandLine().getErr();
        RoombaCommand.requireSpeed(speed);
        String only = scenario;
        List<Scenario> wanted = only == null ? List.of(Scenario.values()) : List.of(Scenario.of(only));
        requireOne(wanted);
        int status = CommandLine.ExitCode.OK;
        for (Scenario next : wanted) {
            if (only == null) {
                System.out.println("=== scenario: " + next);
            }
            try {
                play(next);
                err.println("evoloop: " + next + " ended where it should, by the simulated robot's true state");
            } catch (Play.Unfulfilled broken) {
                status = Math.max(status, CommandLine.ExitCode.SOFTWARE);
                err.println("evoloop: " + next + " failed: " + broken.getMessage());
            } catch (CameraException noCamera) {
                status = CommandLine.ExitCode.USAGE;
                err.println("error: " + next + " cannot be played: " + noCamera.getMessage());
            }
            err.flush();
        }
        return status;
    }

    private void requireOne(List<Scenario> wanted) {
        if (svg != null && wanted.size() > 1) {
            throw new IllegalArgumentException("--svg draws one scenario; say which one with --scenario NAME");
        }
        if (record != null && !wanted.equals(List.of(Scenario.REMOTE_START))) {
            throw new IllegalArgumentException("--record goes with --scenario remote-start, the one with a camera");
        }
    }

    private void play(Scenario next) throws IOException, InterruptedException, Play.Unfulfilled {
        ModelFile file = ModelFile.read(ModelFiles.find("models/cleaning-robot.xml", DemoCommand.class));
        RobotModels models = RobotModels.of(new ModelPair(file.pick("original"), file.pick("new")));
        boolean camera = next == Scenario.REMOTE_START;
        double pace = camera ? Math.min(speed, FASTEST_WITH_CAMERA) : speed;
        if (camera) {
            // A missing OpenCV must be noticed before anything else begins.
            OpenCv.vision();
        }
        try (Clock clock = new SystemClock(pace);
                SimulatedWorld world = twoProcesses
                        ? SimulatedWorld.inAnotherProcess(pace, camera)
                        : SimulatedWorld.inThisProcess(pace, camera)) {
            try (RoombaConverter roomba = RoombaConverter.connect(
                    RoombaCommand.cable(world.port().toString()),
                    RoombaCommand.config(clock, pace),
                    RoombaCommand.sessionOptions(pace * TIMES_USUAL_SILENCE),
                    options(models, world, pace))) {
                roomba.converter().start();
                next.play(new Play(roomba, world, clock));
            }
            if (svg != null) {
                world.draw(svg);
            }
        }
    }

    private RoombaOptions options(RobotModels models, SimulatedWorld world, double pace) {
        return RoombaOptions.of(
                        models,
                        world.camera()
                                .<Function<Clock, StartPointSensor>>map(url -> new Eyes(settings(url), pace))
                                .orElse(clock -> StartPointSensor.byWheels(Scenario.START_X_MM, Scenario.START_Y_MM)))
                .withMove(MoveOptions.defaults().atPace(pace));
    }

    private CameraSettings settings(URI url) {
        CameraSettings settings = CameraSettings.of(CameraSource.parse(url.toString()));
        Path file = record;
        return file == null ? settings : settings.withRecord(file);
    }
}
