package org.evoloop.benchmarks.running;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.HdrHistogram.Histogram;
import org.evoloop.benchmarks.report.SoakSample;
import org.evoloop.journal.Journal;

/** Makes a converter with a journal convert events for a long time, and samples its resource usage. */
public final class Soak {
    private final Path journal;
    private final boolean threads;
    private final List<SoakSample> samples = new ArrayList<>();

    /**
     * @param journal an empty directory for the journal
     * @param threads whether each component and each function has a thread
     */
    public Soak(Path journal, boolean threads) {
        this.journal = journal;
        this.threads = threads;
    }

    /**
     * Converts {@code events} events, one at a time, and takes {@code looks} samples on the way.
     *
     * @throws IllegalStateException if an event was not handled
     */
    public List<SoakSample> run(long events, int looks) throws InterruptedException, IOException {
        PathTimer timer = new PathTimer();
        try (CleaningRobot robot = new CleaningRobot(timer, threads, Journal.in(journal))) {
            long begun = System.nanoTime();
            long done = 0;
            for (int look = 1; look <= looks; look++) {
                timer.clear();
                for (long until = events * look / looks; done < until; done++) {
                    robot.next();
                }
                samples.add(sample(done, (System.nanoTime() - begun) / 1e9, timer.nanos()));
                System.err.println("evoloop: " + samples.get(samples.size() - 1));
            }
            robot.requireAllHandled();
        }
        return List.copyOf(samples);
    }

    @SuppressWarnings("ExplicitGC") // the heap in use after a collection is measured
    private SoakSample sample(long events, double seconds, Histogram nanos) throws IOException {
        System.gc();
        Runtime runtime = Runtime.getRuntime();
        return new SoakSample(
                events,
                seconds,
                (runtime.totalMemory() - runtime.freeMemory()) / 1e6,
                ManagementFactory.getThreadMXBean().getThreadCount(),
                count(Path.of("/proc/self/fd")),
                bytesIn(journal) / 1e6,
                nanos.getValueAtPercentile(50) / 1e3,
                nanos.getValueAtPercentile(99) / 1e3,
                nanos.getValueAtPercentile(99.9) / 1e3);
    }

    private static int count(Path directory) throws IOException {
        try (Stream<Path> files = Files.list(directory)) {
            return (int) files.count();
        }
    }

    private static long bytesIn(Path directory) throws IOException {
        try (Stream<Path> files = Files.list(directory)) {
            return files.mapToLong(Soak::size).sum();
        }
    }

    private static long size(Path file) {
        try {
            return Files.size(file);
        } catch (IOException cause) {
            throw new UncheckedIOException(cause);
        }
    }
}
