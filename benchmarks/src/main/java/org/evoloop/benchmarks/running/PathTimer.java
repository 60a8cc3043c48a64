package org.evoloop.benchmarks.running;

import org.HdrHistogram.Histogram;
import org.evoloop.benchmarks.report.Latencies;

/**
 * Measures events one at a time: from a monitor having the event to the call of the execute component.
 *
 * <p>Threading: one event at a time; the loop orders the calls.
 */
final class PathTimer {
    // Created in advance, since allocation is measured, too.
    private final Histogram nanos = Latencies.histogram();
    private long startNanos;
    private boolean running;

    void start() {
        running = true;
        startNanos = System.nanoTime();
    }

    /** Only the first call for an event has an effect. */
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

    /** The measurements since the last {@link #clear}, in nanoseconds. */
    Histogram nanos() {
        return nanos;
    }
}
