package org.evoloop.time;

import java.time.Duration;

/**
 * Utilities for starting and joining threads.
 *
 * <p>Threading: any thread may call it. Waiting takes real time, whatever {@link Clock} is in use.
 *
 * @since 0.1
 */
public final class Threads {
    private Threads() {}

    /** Runs {@code task} on a daemon thread of its own. */
    public static void start(String name, Runnable task) {
        daemon(name, task).start();
    }

    static Thread daemon(String name, Runnable task) {
        Thread thread = new Thread(task, name);
        thread.setDaemon(true);
        return thread;
    }

    /**
     * Waits for {@code thread} to end. An interrupt of the caller does not cut the wait short; its flag is restored.
     *
     * @param limit in real time
     * @return whether the thread has ended
     */
    public static boolean join(Thread thread, Duration limit) {
        boolean interrupted = false;
        long deadline = System.nanoTime() + limit.toNanos();
        while (thread.isAlive()) {
            long leftMillis = (deadline - System.nanoTime()) / 1_000_000;
            if (leftMillis <= 0) {
                break;
            }
            try {
                thread.join(leftMillis);
            } catch (InterruptedException e) {
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
        return !thread.isAlive();
    }
}
