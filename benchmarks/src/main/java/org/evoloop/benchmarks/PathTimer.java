package org.evoloop.benchmarks;

import org.openjdk.jmh.util.SampleBuffer;

/**
 * Measures one event after the other: from where a monitor has it to where the execute component is called.
 *
 * <p>Threading: one event at a time; whoever starts, stops and reads it is ordered by the loop or by JMH.
 */
final class PathTimer {
    /** JMH makes benchmarks and profilers by itself, in a process of their own; this is where they meet. */
    static final PathTimer SHARED = new PathTimer();

    private static final int CAPACITY = 1 << 20;

    // Made beforehand: allocation is measured, too.
    private final long[] nanos = new long[CAPACITY];
    private long startNanos;
    private boolean running;
    private int recorded;

    void start() {
        running = true;
        startNanos = System.nanoTime();
    }

    /** Only the first call for an event counts. */
    void stop() {
        long now = System.nanoTime();
        if (running) {
            running = false;
            nanos[recorded++ % CAPACITY] = now - startNanos;
        }
    }

    void clear() {
        recorded = 0;
    }

    /** What was measured since the last {@link #clear}, of very many events the last million. */
    SampleBuffer samples() {
        SampleBuffer samples = new SampleBuffer();
        for (int index = 0; index < Math.min(recorded, CAPACITY); index++) {
            samples.add(nanos[index]);
        }
        return samples;
    }
}
