package org.evoloop.benchmarks.profile;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import jdk.jfr.Recording;

/** Records repeated work with Flight Recorder. */
public final class Recorder {
    /** The shortest period that Flight Recorder supports. */
    private static final Duration PERIOD = Duration.ofMillis(1);

    private static final Duration LOAD_PERIOD = Duration.ofMillis(200);

    private Recorder() {}

    /** Work to record, repeated a few thousand times per call; the clock is read between two calls. */
    @FunctionalInterface
    public interface Work {
        void run() throws InterruptedException;
    }

    /**
     * Repeats the work for {@code length} without a recording, so that it is compiled, and then for as long with one.
     *
     * @param file the recording to write
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
