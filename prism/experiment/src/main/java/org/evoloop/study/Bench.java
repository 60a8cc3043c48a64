package org.evoloop.study;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.evoloop.evolution.Occurrence;
import org.evoloop.loop.LoopConfig;
import org.jspecify.annotations.Nullable;

/**
 * A converter of the framework, a simulated device and a controller whose events arrive at random, all in one simulated
 * time: it passes while something in the loop takes time, and what falls due meanwhile (arrivals, disturbances) happens
 * then.
 *
 * <p>A crash ends what the converter does at that moment. The next process begins with a copy of the journal as it was
 * then, which is what a process that was killed leaves behind.
 *
 * <p>Threading: for one thread. If the loop has threads of its own they take turns with that one: time passes by their
 * doing while there is an event in the loop, by the bench's while there is none. So the same seed gives the same run.
 */
final class Bench implements AutoCloseable {
    /** In the clock's time: the device may take as long as it likes, and events wait as long as that. */
    private static final Duration NO_LIMIT = Duration.ofDays(365);

    final SimulatedTime time = new SimulatedTime();
    final Arrivals arrivals = new Arrivals();
    final Agreement agreement = new Agreement();
    final SimulatedDevice device;
    private final Point point;
    private final RandomTimes times;
    private final Surroundings surroundings;
    private final LoopConfig config;
    private final @Nullable Path journals;
    private Life life;
    private LoopDriver driver;
    private int lives;
    private long nextArrivalNanos;

    /** @param threads whether the loop has threads of its own; then nothing disturbs it */
    @SuppressWarnings("NullAway.Init") // begin() sets life and driver
    Bench(Point point, long seed, boolean threads) {
        this.point = point;
        times = new RandomTimes(seed);
        device = new SimulatedDevice(time.clock(), times, point.actionSeconds());
        surroundings = new Surroundings(time, times, point.disturbances(), device, new Disturbed());
        // The event that is in the loop has left the queue.
        LoopConfig usual = LoopConfig.defaults("study", time.clock())
                .withQueueCapacity(point.capacity() - 1)
                .withPressAge(NO_LIMIT)
                .withStepLimit(NO_LIMIT);
        config = threads ? usual : usual.withoutThreads();
        journals = point.disturbances().journal() ? temporaryFolder() : null;
        begin();
        scheduleArrival();
    }

    private static Path temporaryFolder() {
        try {
            return Files.createTempDirectory("study");
        } catch (IOException cause) {
            throw new UncheckedIOException(cause);
        }
    }

    private void begin() {
        RandomAnalyze analyze = new RandomAnalyze(surroundings, times, point);
        RandomExecute execute =
                new RandomExecute(surroundings, time, times, point, device, agreement, () -> settled(analyze.event()));
        life = new Life(config, analyze, execute, journal());
        driver = config.threads()
                ? new ThreadsDriver(life.converter())
                : new StepsDriver(life.converter(), life.controller(), this::mayStep);
    }

    private @Nullable Path journal() {
        return journals == null ? null : journals.resolve("life" + lives);
    }

    private void settled(Occurrence.@Nullable Heard event) {
        if (event != null) {
            arrivals.handOver(event.observedNanos(), time.nanos());
        }
        driver.dealtWith();
    }

    private void scheduleArrival() {
        // No two events arrive at the same time, since events are identified by it.
        long delay = Math.max(1, times.untilArrival(point.arrivalsPerSecond()).toNanos());
        nextArrivalNanos = time.nanos() + delay;
        time.clock().schedule(Duration.ofNanos(delay), this::arrive);
    }

    private void arrive() {
        scheduleArrival();
        arrivals.arrive(time.nanos());
        if (!surroundings.crashed()) {
            life.press(point.steps());
            driver.pressed();
        }
    }

    private final class Disturbed implements Surroundings.Listener {
        @Override
        public void crashed() {
            Path from = journal();
            lives++;
            Path to = journal();
            if (from != null && to != null) {
                copy(from, to);
            }
            // There is no record that could be wrong.
            agreement.note(true, time.nanos());
        }

        @Override
        public void found() {
            life.find(device.state(), time.nanos());
            compare();
        }

        @Override
        public void operated() {
            device.operate();
            compare();
        }
    }

    private static void copy(Path from, Path to) {
        try (Stream<Path> files = Files.list(from)) {
            Files.createDirectory(to);
            for (Path file :
                    (Iterable<Path>) files.filter(file -> file.toString().endsWith(".journal"))::iterator) {
                Files.copy(file, to.resolve(file.getFileName()));
            }
        } catch (IOException cause) {
            throw new UncheckedIOException(cause);
        }
    }

    private void forgetFormerLife() {
        if (journals != null) {
            delete(journals.resolve("life" + (lives - 1)));
        }
    }

    private void compare() {
        agreement.note(life.record().equals(device.state()), time.nanos());
    }

    /** Between two events: whether the next one may begin, once other models have taken over if they are to. */
    private boolean mayStep() {
        if (!surroundings.crashed() && surroundings.wantsSwap()) {
            life.swap();
            surroundings.pause();
            surroundings.swapped();
        }
        return !surroundings.crashed();
    }

    /** Lets time pass until something happens, and until the converter has nothing left to do. */
    void go() {
        time.passUntil(Math.min(nextArrivalNanos, surroundings.nextNanos()));
        driver.settle();
        while (surroundings.crashed()) {
            life.close();
            forgetFormerLife();
            time.pass(surroundings.untilRecovery());
            surroundings.started();
            begin();
            compare();
            driver.settle();
        }
    }

    @Override
    public void close() {
        life.close();
        if (journals != null) {
            delete(journals);
        }
    }

    private static void delete(Path folder) {
        try (Stream<Path> all = Files.walk(folder)) {
            List<Path> deepestFirst = all.sorted(Comparator.reverseOrder()).toList();
            for (Path path : deepestFirst) {
                Files.delete(path);
            }
        } catch (IOException cause) {
            throw new UncheckedIOException(cause);
        }
    }
}
