package org.evoloop.benchmarks.running;

import java.time.Duration;
import java.util.concurrent.atomic.AtomicLong;
import org.evoloop.time.Clock;

/**
 * Events that monitors report as fast as they can, counted when they are executed, by one thread at a time. The events
 * of each monitor must stay in order. Events that find the queue full are lost.
 */
public final class Flood {
    /** The number of monitors. */
    public static final int MONITORS = 4;
    /** The capacity of the queue. */
    public static final int CAPACITY = 1024;

    private final long[] last = new long[MONITORS];
    private final AtomicLong executed = new AtomicLong();
    private volatile boolean broken;

    /** The {@code number}th event of a monitor, counted from 1. */
    public record NumberedEvent(int monitor, long number) {}

    /** Counts an event as executed. */
    public void execute(NumberedEvent event) {
        if (event.number <= last[event.monitor]) {
            broken = true;
        }
        last[event.monitor] = event.number;
        // Only one thread writes, so no fence is needed.
        executed.lazySet(executed.getPlain() + 1);
    }

    /** The number of executed events. */
    public long executed() {
        return executed.get();
    }

    /** Executed events per second, after a warm-up. */
    public double rate(Clock clock, Duration warmUp, Duration watched) throws InterruptedException {
        clock.sleep(warmUp);
        long before = executed();
        long begun = System.nanoTime();
        clock.sleep(watched);
        double rate = (executed() - before) * 1e9 / (System.nanoTime() - begun);
        requireOrder();
        return rate;
    }

    /**
     * Checks the order of the events.
     *
     * @throws IllegalStateException if events of a monitor came out of order
     */
    public void requireOrder() {
        if (broken) {
            throw new IllegalStateException("occurrences of a monitor came out of order");
        }
    }
}
