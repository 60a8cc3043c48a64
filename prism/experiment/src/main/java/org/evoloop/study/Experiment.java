package org.evoloop.study;

import java.time.Duration;

/**
 * Measures one point in two ways: many short runs from the empty system, as the paper's properties see it, and one long
 * run, for what holds in the long run. What is counted is counted afterwards, from when each event arrived, was handed
 * over and was carried out.
 *
 * <p>Quantities: {@code lost} and {@code done} at each time and {@code completion_s} of each short run; {@code
 * divergence_s} of every run in which belief and device come to differ; {@code handed}, the events that the device has
 * by a time; {@code lost_per_s}, {@code wait_s}, {@code differs} (the share of time in which they differ) and {@code
 * longer} (the share of events that wait longer than a time) of each batch of the long run; {@code events} of each
 * short run and {@code events_long_run}.
 *
 * <p>Threading: for one thread.
 */
final class Experiment {
    private static final int HORIZON_SECONDS = 100;
    private static final int INTERVAL_SECONDS = 5;
    private static final int DECISIONS = 19;
    private static final int LONGEST_WAIT_SECONDS = 10;
    private static final int BATCHES = 100;
    private static final double NANOS = 1e9;

    private final Point point;
    private final boolean threads;
    private final Results results = new Results();

    /** @param threads whether the converter's loop has threads of its own */
    Experiment(Point point, boolean threads) {
        this.point = point;
        this.threads = threads;
    }

    Results run(int shortRuns, int batchSeconds) {
        for (int run = 0; run < shortRuns; run++) {
            shortRun(run);
        }
        longRun(batchSeconds);
        return results;
    }

    private void shortRun(int number) {
        // Far apart, so that no two runs of two points share a seed.
        try (Bench bench = new Bench(point, point.seed() * 1_000_003 + number, threads)) {
            int lastAction = DECISIONS * point.steps();
            while (bench.time.nanos() < nanos(HORIZON_SECONDS)
                    || bench.device.ready().size() < lastAction
                    || mayDiverge(bench)) {
                bench.go();
            }
            long doneNanos = bench.device.ready().at(lastAction);
            for (int second = INTERVAL_SECONDS; second <= HORIZON_SECONDS; second += INTERVAL_SECONDS) {
                results.add("lost", second, (double) lost(bench, 0, nanos(second)));
                results.add("done", second, doneNanos <= nanos(second) ? 1 : 0);
            }
            results.add("handed", HORIZON_SECONDS, (double) bench.arrivals.handedOver(nanos(HORIZON_SECONDS)));
            results.add("completion_s", 0, doneNanos / NANOS);
            noteDivergence(bench);
            results.add("events", 0, (double) bench.arrivals.size());
        }
    }

    private static long nanos(long seconds) {
        return Duration.ofSeconds(seconds).toNanos();
    }

    /** Events that were never handed over, at their arrival, and events that the device was not ready for. */
    private static long lost(Bench bench, long firstNanos, long lastNanos) {
        TimeLog inDevice = bench.device.lost();
        return bench.arrivals.lost(firstNanos, lastNanos) + inDevice.until(lastNanos) - inDevice.until(firstNanos);
    }

    /** Whether the run must continue until belief and device differ; with back-pressure alone they never do. */
    private boolean mayDiverge(Bench bench) {
        boolean backPressure =
                point.mechanism() == Point.Mechanism.SERIAL || point.mechanism() == Point.Mechanism.PIPELINED;
        return (!backPressure || point.disturbances().part()) && bench.agreement.divergedNanos() < 0;
    }

    private void noteDivergence(Bench bench) {
        if (bench.agreement.divergedNanos() >= 0) {
            results.add("divergence_s", 0, bench.agreement.divergedNanos() / NANOS);
        }
    }

    /** The first batch is left out: the system begins empty. */
    private void longRun(int batchSeconds) {
        try (Bench bench = new Bench(point, point.seed(), threads)) {
            while (bench.time.nanos() < nanos((BATCHES + 1L) * batchSeconds)) {
                bench.go();
            }
            for (long number = 1; number <= BATCHES; number++) {
                long begin = nanos(number * batchSeconds);
                long end = nanos((number + 1) * batchSeconds);
                WaitBatch batch = new WaitBatch(LONGEST_WAIT_SECONDS);
                bench.arrivals.waits(begin, end, batch::add);
                results.add("lost_per_s", 0, lost(bench, begin, end) / (double) batchSeconds);
                results.add("wait_s", 0, batch.meanSeconds());
                results.add("differs", 0, bench.agreement.wrongNanos(begin, end) / (double) (end - begin));
                for (int second = 1; second <= LONGEST_WAIT_SECONDS; second++) {
                    results.add("longer", second, batch.shareLongerThan(second));
                }
            }
            results.add("events_long_run", 0, (double) bench.arrivals.size());
            noteDivergence(bench);
        }
    }
}
