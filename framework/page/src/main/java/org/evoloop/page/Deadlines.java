package org.evoloop.page;

import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import org.evoloop.time.Clock;
import org.evoloop.time.Threads;

/**
 * Limits the wait for clients: the thread that serves a client that does not take its answer in time is interrupted,
 * which closes the connection.
 *
 * <p>Threading: thread-safe. A thread watches the deadlines while there are any, and some seconds longer.
 */
final class Deadlines {
    private static final int LOOK_MILLIS = 500;
    private static final int LOOKS_IN_VAIN = 10;

    private final Clock clock;
    private final Map<Thread, Long> due = new HashMap<>();
    private boolean watched;
    private boolean closed;

    Deadlines(Clock clock) {
        this.clock = clock;
    }

    /** Starts a deadline for the caller's thread. */
    synchronized void begin(Duration limit) {
        due.put(Thread.currentThread(), clock.nanoTime() + limit.toNanos());
        if (!watched && !closed) {
            watched = true;
            Threads.start("evoloop-page-deadlines", this::watch);
        }
    }

    /** Ends the caller's deadline, met or not. */
    synchronized void end() {
        due.remove(Thread.currentThread());
        if (!closed) {
            // It may have been interrupted after the last byte, when there was nothing left to stop.
            Thread.interrupted();
        }
    }

    private void watch() {
        synchronized (this) {
            try {
                for (int inVain = 0; inVain < LOOKS_IN_VAIN && !closed; inVain = due.isEmpty() ? inVain + 1 : 0) {
                    long now = clock.nanoTime();
                    due.forEach((thread, deadline) -> {
                        if (now - deadline >= 0) {
                            thread.interrupt();
                        }
                    });
                    wait(LOOK_MILLIS);
                }
            } catch (InterruptedException never) {
                Thread.currentThread().interrupt();
            } finally {
                watched = false;
            }
        }
    }

    /** Ends the watching. */
    synchronized void close() {
        closed = true;
        notifyAll();
    }
}
