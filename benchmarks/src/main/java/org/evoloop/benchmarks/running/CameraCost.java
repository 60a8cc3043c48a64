package org.evoloop.benchmarks.running;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import org.HdrHistogram.Histogram;
import org.evoloop.roomba.camera.CameraSource;
import org.evoloop.roomba.camera.live.CameraSettings;
import org.evoloop.roomba.camera.live.VideoCamera;
import org.evoloop.roomba.camera.vision.OpenCv;
import org.evoloop.roomba.simulator.SimulatorServer;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.roomba.simulator.webcam.WebcamOptions;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;

/**
 * What a camera that is looked at costs the events of a converter in the same process: events a millisecond apart, by turns
 * with the simulated robot's camera watched at 30 frames a second and without. The pictures are drawn in this process as
 * well, which a real camera would not ask for.
 */
public final class CameraCost {
    private static final int TURNS = 10;
    private static final int EVENTS = 1_000;
    private static final long PAUSE_NANOS = 1_000_000;

    private CameraCost() {}

    /**
     * Prints medians and 99th percentiles in microseconds.
     *
     * @param arguments none
     */
    public static void main(String[] arguments) throws Exception {
        PathTimer timer = new PathTimer();
        Histogram without = new Histogram(10_000_000_000L, 3);
        Histogram with = new Histogram(10_000_000_000L, 3);
        Path folder = Files.createTempDirectory("evoloop");
        Path port = folder.resolve("roomba");
        long looked = 0;
        try (Clock clock = new SystemClock();
                SimulatorServer robot = SimulatorServer.start(
                        port, RobotOptions.defaults(), clock, 1, state -> {}, Optional.of(WebcamOptions.defaults()));
                CleaningRobot converter = new CleaningRobot(timer, true)) {
            CameraSource source =
                    CameraSource.parse(robot.camera().orElseThrow().url().toString());
            events(converter, timer, new Histogram(10_000_000_000L, 3));
            for (int turn = 0; turn < TURNS; turn++) {
                events(converter, timer, without);
                try (VideoCamera camera = VideoCamera.open(OpenCv.vision(), CameraSettings.of(source), clock)) {
                    while (camera.counts().looked() == 0) {
                        LockSupport.parkNanos(PAUSE_NANOS);
                    }
                    events(converter, timer, with);
                    looked += camera.counts().looked();
                }
            }
            converter.requireAllHandled();
        } finally {
            Files.deleteIfExists(port);
            Files.delete(folder);
        }
        print("without", without);
        print("with", with);
        System.out.println("frames " + looked);
    }

    private static void events(CleaningRobot converter, PathTimer timer, Histogram nanos) throws InterruptedException {
        timer.clear();
        for (int event = 0; event < EVENTS; event++) {
            LockSupport.parkNanos(PAUSE_NANOS);
            converter.next();
        }
        nanos.add(timer.nanos());
    }

    private static void print(String name, Histogram nanos) {
        System.out.println(name + " p50 " + nanos.getValueAtPercentile(50) / 1e3);
        System.out.println(name + " p99 " + nanos.getValueAtPercentile(99) / 1e3);
    }
}
