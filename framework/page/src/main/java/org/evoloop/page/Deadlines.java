package org.evoloop.page;

import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import org.evoloop.time.Clock;
import org.evoloop.time.Threads;

/**
 * Nobody waits for a client for ever: who has not taken its answer in time is hung up on. The thread that waits for it
 * is interrupted, which closes its connection.
 *
 * <p>Threading: thread-safe. A thread looks after the deadlines while there are any, and some seconds longer.
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

    /** The caller has as long as this, from now on. */
    synchronized void begin(Duration limit) {
        due.put(Thread.currentThread(), clock.nanoTime() + limit.toNanos());
        if (!watched && !closed) {
            watched = true;
            Threads.start("evoloop-page-deadlines", this::watch);
        }
    }

    /** The caller was in time, or was interrupted. */
    synchronized void end() {
        due.remove(Thread.currentThread());
        if (!closed) {
            // Between the last byte and here it may just have been told to stop, and there is nothing to stop any more.
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

    /** Looks after nothing any more. */
    synchronized void close() {
        closed = true;
        notifyAll();
    }
}
