package org.evoloop.time;

import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.CountDownLatch;

/**
 * Two clocks and a timer: monotonic time for durations, wall time for timestamps.
 *
 * <p>Threading: all methods may be called from any thread.
 *
 * @since 0.1
 */
public interface Clock extends AutoCloseable {

    /** The longest delay that a clock takes: a century. */
    Duration LONGEST = Duration.ofDays(36_500);

    /**
     * Returns {@code delay} after checking that a clock accepts it.
     *
     * @throws IllegalArgumentException if it is negative, or longer than {@link #LONGEST}
     */
    static Duration requireDelay(Duration delay) {
        if (delay.isNegative() || delay.compareTo(LONGEST) > 0) {
            throw new IllegalArgumentException(
                    "the delay is " + delay + ", allowed is 0 to " + LONGEST.toDays() + " days");
        }
        return delay;
    }

    /** Nanoseconds since an arbitrary origin; never goes back. Only differences are meaningful. */
    long nanoTime();

    /** The time of day; may jump. */
    Instant wallTime();

    /**
     * Runs {@code task} once, {@code delay} from now, on the clock's own thread. It must be short and not throw.
     *
     * @throws IllegalArgumentException if {@code delay} is negative, or longer than {@link #LONGEST}
     */
    Timer schedule(Duration delay, Runnable task);

    /**
     * Waits for {@code duration} of this clock's time.
     *
     * @throws InterruptedException if the thread is interrupted first
     * @throws IllegalStateException if the caller is a task of this clock, which would wait for itself
     */
    default void sleep(Duration duration) throws InterruptedException {
        if (ownsCurrentThread()) {
            throw new IllegalStateException("a task of the clock cannot wait for the clock; schedule what comes after");
        }
        CountDownLatch over = new CountDownLatch(1);
        Timer timer = schedule(duration, over::countDown);
        try {
            over.await();
        } finally {
            timer.cancel();
        }
    }

    /** Whether the caller is a task of this clock. */
    boolean ownsCurrentThread();

    /** Ends the clock's thread; tasks that are not due yet never run. Idempotent. */
    @Override
    void close();

    /** A task that waits for its time. */
    interface Timer {
        /** Cancels the task, unless it has begun, and releases it. Idempotent. */
        void cancel();
    }
}
