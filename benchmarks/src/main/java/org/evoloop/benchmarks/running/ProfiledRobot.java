package org.evoloop.benchmarks.running;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import org.evoloop.benchmarks.profile.Recorder;

/** Whole conversions of the paper's robot, to be recorded by Flight Recorder. */
public final class ProfiledRobot {
    private static final int AT_ONCE = 1000;

    private ProfiledRobot() {}

    /**
     * Writes a recording.
     *
     * @param arguments the recording's file, its length in seconds, and {@code threads} for a converter with threads
     */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        try (CleaningRobot robot = new CleaningRobot(new PathTimer(), arguments[2].equals("threads"))) {
            Recorder.record(Path.of(arguments[0]), Duration.ofSeconds(Long.parseLong(arguments[1])), () -> {
                for (int event = 0; event < AT_ONCE; event++) {
                    robot.next();
                }
            });
            robot.requireAllHandled();
        }
    }
}
