package org.evoloop.study;

import java.time.Duration;

/**
 * Measures one point in two ways: many short runs from the empty system, as the paper's properties see it, and one long
 * run, for what holds in the long run.
 *
 * <p>Quantities: {@code lost} and {@code done} at each time and {@code completion_s} of each short run;
 * {@code divergence_s} of every run in which belief and device come to differ; {@code lost_per_s}, {@code wait_s} and {@code longer} (the share of events that wait longer than a time) of each
 * batch of the long run; {@code events} of each short run and {@code events_long_run}.
 *
 * <p>Threading: for one thread.
 */
final class Experiment {
    private static final int HORIZON_SECONDS = 100;
    private static final int INTERVAL_SECONDS = 5;
    private static final int DECISIONS = 19;
    private static final int LONGEST_WAIT_SECONDS = 10;
    private static final int BATCHES = 100;
    private static final int BATCH_SECONDS = 2400;
    private static final double NANOS = 1e9;

    private final Point point;
    private final Results results = new Results();

    Experiment(Point point) {
        this.point = point;
    }

    Results run(int shortRuns) {
        for (int run = 0; run < shortRuns; run++) {
            shortRun(run);
        }
        longRun();
        return results;
    }

    private void shortRun(int number) {
        // Far apart, so that no two runs of two points share a seed.
        try (Bench bench = new Bench(point, point.seed() * 1_000_003 + number, wait -> {})) {
            for (int second = INTERVAL_SECONDS; second <= HORIZON_SECONDS; second += INTERVAL_SECONDS) {
                int time = second;
                bench.clock.schedule(Duration.ofSeconds(time), () -> results.add("lost", time, (double) bench.lost()));
            }
            long lastAction = (long) DECISIONS * point.steps();
            long doneNanos = -1;
            while (bench.clock.nanoTime() < HORIZON_SECONDS * NANOS || doneNanos < 0 || mayDiverge(bench)) {
                bench.go();
                if (doneNanos < 0 && bench.device.actions() >= lastAction) {
                    doneNanos = bench.device.readyNanos();
                }
            }
            for (int second = INTERVAL_SECONDS; second <= HORIZON_SECONDS; second += INTERVAL_SECONDS) {
                results.add("done", second, doneNanos <= second * NANOS ? 1 : 0);
            }
            results.add("completion_s", 0, doneNanos / NANOS);
            noteDivergence(bench);
            results.add("events", 0, (double) bench.arrived());
        }
    }

    /** Whether the run has to go on until belief and device differ; with back-pressure they never do. */
    private boolean mayDiverge(Bench bench) {
        boolean backPressure =
                point.mechanism() == Point.Mechanism.SERIAL || point.mechanism() == Point.Mechanism.PIPELINED;
        return !backPressure && bench.divergedNanos() < 0;
    }

    private void noteDivergence(Bench bench) {
        if (bench.divergedNanos() >= 0) {
            results.add("divergence_s", 0, bench.divergedNanos() / NANOS);
        }
    }

    private void longRun() {
        WaitBatch batch = new WaitBatch(LONGEST_WAIT_SECONDS);
        try (Bench bench = new Bench(point, point.seed(), batch::add)) {
            runUntil(bench, BATCH_SECONDS);
            for (int number = 1; number <= BATCHES; number++) {
                batch.clear();
                long lost = bench.lost();
                runUntil(bench, (number + 1L) * BATCH_SECONDS);
                results.add("lost_per_s", 0, (bench.lost() - lost) / (double) BATCH_SECONDS);
                results.add("wait_s", 0, batch.meanSeconds());
                for (int second = 1; second <= LONGEST_WAIT_SECONDS; second++) {
                    results.add("longer", second, batch.shareLongerThan(second));
                }
            }
            results.add("events_long_run", 0, (double) bench.arrived());
            noteDivergence(bench);
        }
    }

    private static void runUntil(Bench bench, long second) {
        while (bench.clock.nanoTime() < second * NANOS) {
            bench.go();
        }
    }
}
