package org.evoloop.link;

import static java.util.concurrent.TimeUnit.NANOSECONDS;

/**
 * Waits that an interrupt does not cut short, because the waiting code leaves a device safe; each has a limit instead.
 * The interrupt flag is restored for the caller.
 *
 * <p>Threading: stateless.
 *
 * @since 0.1
 */
public final class BoundedWait {
    private BoundedWait() {}

    /** One wait of the concurrency library. */
    @FunctionalInterface
    interface Attempt {
        /** Returns whether the condition was met in time. */
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
