package org.evoloop.benchmarks.running;

import com.sun.management.OperatingSystemMXBean;
import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.HdrHistogram.Histogram;
import org.evoloop.roomba.camera.CameraSource;
import org.evoloop.roomba.camera.live.CameraSettings;
import org.evoloop.roomba.camera.live.VideoCamera;
import org.evoloop.roomba.camera.vision.OpenCv;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;

/**
 * How much a watched camera delays the events of a converter in the same process. Events occur at random moments,
 * alternately without a camera and with one. The camera is {@link CameraPlayer}, a separate process. A turn disturbed
 * by other processes says nothing about the camera, and is repeated.
 */
public final class CameraCost {
    private static final int PAIRS = 30;
    private static final int LEAST_PAIRS = 10;
    private static final int EVENTS = 250;
    private static final long SHORTEST_PAUSE_NANOS = TimeUnit.MICROSECONDS.toNanos(500);
    private static final long LONGEST_PAUSE_NANOS = TimeUnit.MICROSECONDS.toNanos(3_500);
    private static final long SEED = 1;

    /** Warm-up of decoder and compiler. */
    private static final int FIRST_FRAMES = 10;

    /** Relative to all processors; the player uses 1 or 2 %, a compiler on one of four processors 25 %. */
    private static final double MOST_BY_OTHERS = 0.05;

    private static final long PROBE_NANOS = TimeUnit.MILLISECONDS.toNanos(200);
    private static final long LIMIT_NANOS = TimeUnit.SECONDS.toNanos(100);

    private final OperatingSystemMXBean machine = ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);
    private final long endNanos = System.nanoTime() + LIMIT_NANOS;
    private final SplittableRandom random = new SplittableRandom(SEED);
    private final CameraSource source;
    private final Clock clock;
    private final PathTimer timer;
    private final CleaningRobot converter;
    private double lastShareOfOthers;
    private long looked;
    private long detections;
    private long watchedNanos;
    private int disturbed;

    private CameraCost(CameraSource source, Clock clock, PathTimer timer, CleaningRobot converter) {
        this.source = source;
        this.clock = clock;
        this.timer = timer;
        this.converter = converter;
    }

    private interface Turn {
        /** The latencies of a turn's events, in nanoseconds. */
        Histogram take() throws InterruptedException;
    }

    /**
     * Prints a table of percentiles, within two minutes.
     *
     * @param arguments a camera to watch instead of the player, in the form of the option {@code --camera}
     */
    public static void main(String[] arguments) throws Exception {
        if (arguments.length > 0) {
            measure(CameraSource.parse(arguments[0]));
            return;
        }
        Process player = player();
        try (BufferedReader address = player.inputReader(StandardCharsets.UTF_8)) {
            measure(CameraSource.parse(address.readLine()));
        } finally {
            player.destroy();
        }
    }

    private static Process player() throws IOException {
        return new ProcessBuilder(
                        new File(System.getProperty("java.home"), "bin/java").getPath(),
                        "-cp",
                        System.getProperty("java.class.path"),
                        CameraPlayer.class.getName())
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
    }

    private static void measure(CameraSource source) throws InterruptedException {
        PathTimer timer = new PathTimer();
        try (Clock clock = new SystemClock();
                CleaningRobot converter = new CleaningRobot(timer, true)) {
            new CameraCost(source, clock, timer, converter).measure();
            converter.requireAllHandled();
        }
    }

    private void measure() throws InterruptedException {
        withoutCamera();
        withCamera();
        looked = 0;
        detections = 0;
        watchedNanos = 0;
        CameraTurns turns = new CameraTurns();
        while (turns.pairs() < PAIRS) {
            Optional<Histogram> without = undisturbed(this::withoutCamera);
            Optional<Histogram> with = undisturbed(this::withCamera);
            if (without.isEmpty() || with.isEmpty()) {
                break;
            }
            turns.add(without.get(), with.get());
            System.err.printf("pair %d of %d, %d turns disturbed%n", turns.pairs(), PAIRS, disturbed);
        }
        if (turns.pairs() < LEAST_PAIRS) {
            throw new IllegalStateException("other processes were busy in " + disturbed + " turns and left "
                    + turns.pairs() + " pairs of turns; it takes " + LEAST_PAIRS + ": end them and measure again");
        }
        System.out.printf(
                "%d pairs of turns of %d events, %d other turns disturbed by other processes%n"
                        + "%.1f frames looked at in a second, marker in %.0f %% of them, on %d processors%n%s",
                turns.pairs(),
                EVENTS,
                disturbed,
                looked * 1e9 / watchedNanos,
                100.0 * detections / looked,
                Runtime.getRuntime().availableProcessors(),
                turns.table());
    }

    /**
     * Waits until the machine is quiet, and repeats the turn until the machine stayed quiet throughout; empty if time
     * runs out.
     */
    private Optional<Histogram> undisturbed(Turn turn) throws InterruptedException {
        boolean quiet = true;
        while (System.nanoTime() < endNanos) {
            if (!quiet) {
                shareOfOthers();
                LockSupport.parkNanos(PROBE_NANOS);
                quiet = shareOfOthers() <= MOST_BY_OTHERS;
                continue;
            }
            Histogram nanos = turn.take();
            quiet = lastShareOfOthers <= MOST_BY_OTHERS;
            if (quiet) {
                return Optional.of(nanos);
            }
            disturbed++;
        }
        return Optional.empty();
    }

    private Histogram withCamera() throws InterruptedException {
        try (VideoCamera camera = VideoCamera.open(OpenCv.vision(), CameraSettings.of(source), clock)) {
            while (camera.counts().looked() < FIRST_FRAMES) {
                LockSupport.parkNanos(SHORTEST_PAUSE_NANOS);
            }
            VideoCamera.Counts before = camera.counts();
            long begun = System.nanoTime();
            Histogram nanos = withoutCamera();
            watchedNanos += System.nanoTime() - begun;
            looked += camera.counts().looked() - before.looked();
            detections += camera.counts().detections() - before.detections();
            return nanos;
        }
    }

    private Histogram withoutCamera() throws InterruptedException {
        timer.clear();
        shareOfOthers();
        for (int event = 0; event < EVENTS; event++) {
            LockSupport.parkNanos(random.nextLong(SHORTEST_PAUSE_NANOS, LONGEST_PAUSE_NANOS));
            converter.next();
        }
        lastShareOfOthers = shareOfOthers();
        return timer.nanos().copy();
    }

    /** The share of all processors that other processes have used since the last call, 0 to 1. */
    private double shareOfOthers() {
        return machine.getCpuLoad() - machine.getProcessCpuLoad();
    }
}
