package org.evoloop.benchmarks.running;

import org.HdrHistogram.Histogram;
import org.evoloop.benchmarks.report.Latencies;

/**
 * Measures one event after the other: from where a monitor has it to where the execute component is called.
 *
 * <p>Threading: one event at a time; whoever starts, stops and reads it is ordered by the loop.
 */
final class PathTimer {
    // Made beforehand: allocation is measured, too.
    private final Histogram nanos = Latencies.histogram();
    private long startNanos;
    private boolean running;

    void start() {
        running = true;
        startNanos = System.nanoTime();
    }

    /** Only the first call for an event counts. */
    void stop() {
        long now = System.nanoTime();
        if (running) {
            running = false;
            nanos.recordValue(now - startNanos);
        }
    }

    void clear() {
        nanos.reset();
    }

    /** What was measured since the last {@link #clear}, in nanoseconds. */
    Histogram nanos() {
        return nanos;
    }
}
