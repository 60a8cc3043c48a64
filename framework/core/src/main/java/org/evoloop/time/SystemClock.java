package org.evoloop.time;

import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/**
 * The machine's clock, optionally running faster: at speed 20 a second of this clock lasts 50 ms.
 *
 * <p>Threading: thread-safe. Tasks run one after another on a daemon thread that sleeps while none is due.
 *
 * @since 0.1
 */
public final class SystemClock implements Clock {
    private final double speed;
    private final long originNanos = System.nanoTime();
    private final Instant originWall = Instant.now();
    private final ScheduledThreadPoolExecutor timers;
    private volatile @Nullable Thread own;

    /** The machine's clock at normal speed. */
    public SystemClock() {
        this(1);
    }

    /**
     * @param speed how many seconds of this clock pass in a second, 0.01 to 1000
     * @throws IllegalArgumentException if {@code speed} is out of range
     */
    public SystemClock(double speed) {
        if (!(speed >= 0.01 && speed <= 1000)) {
            throw new IllegalArgumentException("speed " + speed + " is not between 0.01 and 1000");
        }
        this.speed = speed;
        timers = new ScheduledThreadPoolExecutor(1, task -> {
            Thread thread = Threads.daemon("evoloop-clock", task);
            own = thread;
            return thread;
        });
        timers.setRemoveOnCancelPolicy(true);
        timers.setExecuteExistingDelayedTasksAfterShutdownPolicy(false);
    }

    @Override
    public long nanoTime() {
        return (long) ((System.nanoTime() - originNanos) * speed);
    }

    @Override
    public Instant wallTime() {
        return speed == 1 ? Instant.now() : originWall.plusNanos(nanoTime());
    }

    @Override
    public Timer schedule(Duration delay, Runnable task) {
        ScheduledFuture<?> pending =
                timers.schedule(task, Math.round(Clock.requireDelay(delay).toNanos() / speed), TimeUnit.NANOSECONDS);
        return () -> pending.cancel(false);
    }

    @Override
    public boolean ownsCurrentThread() {
        return own == Thread.currentThread();
    }

    @Override
    public void close() {
        timers.shutdownNow();
    }
}
