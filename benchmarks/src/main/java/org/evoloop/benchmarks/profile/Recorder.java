package org.evoloop.benchmarks.profile;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import jdk.jfr.Recording;

/** Has Flight Recorder look at work that goes on and on. */
public final class Recorder {
    /** As often as Flight Recorder can look. */
    private static final Duration PERIOD = Duration.ofMillis(1);

    private static final Duration LOAD_PERIOD = Duration.ofMillis(200);

    private Recorder() {}

    /** Something worth looking at, done a few thousand times: the clock is read between two calls. */
    @FunctionalInterface
    public interface Work {
        void run() throws InterruptedException;
    }

    /**
     * Does the work for as long without being looked at, so that it is compiled, and then while recorded.
     *
     * @param file what the recording is written to
     */
    public static void record(Path file, Duration length, Work work) throws IOException, InterruptedException {
        repeat(length, work);
        try (Recording recording = new Recording()) {
            recording.enable(Profile.SAMPLE).withPeriod(PERIOD);
            recording.enable(Profile.ALLOCATION).with("throttle", "1000/s").withStackTrace();
            recording.enable(Profile.LOAD).withPeriod(LOAD_PERIOD);
            recording.start();
            repeat(length, work);
            recording.stop();
            recording.dump(file);
        }
    }

    private static void repeat(Duration length, Work work) throws InterruptedException {
        long begun = System.nanoTime();
        while (System.nanoTime() - begun < length.toNanos()) {
            work.run();
        }
    }
}
