package org.evoloop.benchmarks.running;

import java.time.Duration;
import java.util.concurrent.atomic.AtomicLong;
import org.evoloop.time.Clock;

/**
 * What monitors tell as fast as they can, counted where it is executed, by one thread at a time; each monitor's must
 * come in order. What found the queue full is lost.
 */
public final class Flood {
    /** How many monitors there are. */
    public static final int MONITORS = 4;
    /** How much may wait. */
    public static final int CAPACITY = 1024;

    private final long[] last = new long[MONITORS];
    private final AtomicLong executed = new AtomicLong();
    private volatile boolean broken;

    /** The {@code number}th that a monitor tells, from 1. */
    public record Told(int monitor, long number) {}

    /** {@code told} has come to its end. */
    public void execute(Told told) {
        if (told.number <= last[told.monitor]) {
            broken = true;
        }
        last[told.monitor] = told.number;
        // Only one thread writes, so that no fence is needed.
        executed.lazySet(executed.getPlain() + 1);
    }

    /** How many have come to their end. */
    public long executed() {
        return executed.get();
    }

    /** Events a second that come to their end, after so long to warm up. */
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
     * Ends the measurement if order was lost.
     *
     * @throws IllegalStateException if occurrences of a monitor came out of order
     */
    public void requireOrder() {
        if (broken) {
            throw new IllegalStateException("occurrences of a monitor came out of order");
        }
    }
}
