package org.evoloop.link;

import static java.util.concurrent.TimeUnit.NANOSECONDS;

/**
 * Waits that an interrupt does not cut short, because what waits here leaves a device safe; each has a limit instead.
 * The interrupt flag is restored for the caller.
 *
 * <p>Threading: pure functions, but for the time they take.
 *
 * @since 0.1
 */
public final class BoundedWait {
    private BoundedWait() {}

    /** One wait, as the concurrency library offers it. */
    @FunctionalInterface
    interface Attempt {
        /** Returns whether that came which was waited for. */
        boolean within(long nanos) throws InterruptedException;
    }

    /** Waits for a thread to end; false if it did not end in time. */
    public static boolean forEnd(Thread thread, long limitNanos) {
        return uninterruptibly(limitNanos, nanos -> {
            NANOSECONDS.timedJoin(thread, nanos);
            return !thread.isAlive();
        });
    }

    static boolean uninterruptibly(long limitNanos, Attempt attempt) {
        long deadline = System.nanoTime() + limitNanos;
        boolean interrupted = false;
        try {
            while (true) {
                try {
                    return attempt.within(Math.max(0, deadline - System.nanoTime()));
                } catch (InterruptedException later) {
                    interrupted = true;
                }
            }
        } finally {
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }
}
