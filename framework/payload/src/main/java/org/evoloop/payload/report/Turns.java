package org.evoloop.payload.report;

import java.util.ArrayDeque;
import java.util.Queue;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Lets reports and timers have their turn one after another, in the order in which they came: whatever a timer concludes
 * is told before the next report is heard. Nobody waits: what comes meanwhile is run by the thread that is at it.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class Turns {
    private static final Logger LOG = LoggerFactory.getLogger(Turns.class);

    private final Queue<Runnable> due = new ArrayDeque<>();
    private boolean running;

    /** No turns are taken yet. */
    public Turns() {}

    /** Runs a task when its turn has come; one that fails is logged. */
    public void take(Runnable task) {
        synchronized (this) {
            due.add(task);
            if (running) {
                return;
            }
            running = true;
        }
        for (Runnable next = next(); next != null; next = next()) {
            run(next);
        }
    }

    private synchronized @Nullable Runnable next() {
        Runnable next = due.poll();
        running = next != null;
        return next;
    }

    private static void run(Runnable task) {
        try {
            task.run();
        } catch (RuntimeException wrong) {
            LOG.warn("what a report or a timer says could not be handled", wrong);
        }
    }
}
