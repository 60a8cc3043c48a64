package org.evoloop.time;

import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.CountDownLatch;

/**
 * Two clocks and a timer: monotonic time for durations, wall time for stamps that people read.
 *
 * <p>Threading: all methods may be called from any thread.
 */
public interface Clock extends AutoCloseable {

    /** Nanoseconds since some moment; never goes back. Only differences mean something. */
    long nanoTime();

    /** The time of day; may jump. */
    Instant wallTime();

    /**
     * Runs {@code task} once, {@code delay} from now, on the clock's own thread. It must be short and not throw.
     *
     * @param delay not negative
     */
    Timer schedule(Duration delay, Runnable task);

    /**
     * Waits for {@code duration} of this clock's time.
     *
     * @throws InterruptedException if the thread is told to stop first
     */
    default void sleep(Duration duration) throws InterruptedException {
        CountDownLatch over = new CountDownLatch(1);
        Timer timer = schedule(duration, over::countDown);
        try {
            over.await();
        } finally {
            timer.cancel();
        }
    }

    /** Ends the clock's thread; tasks that are not due yet never run. Idempotent. */
    @Override
    void close();

    /** A task that waits for its time. */
    interface Timer {
        /** Calls the task off, unless it has begun; it holds nothing afterwards. Idempotent. */
        void cancel();
    }
}
