package org.evoloop.roomba.session.connection;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Runs a connection's tasks, now or later: on its own thread or, without waiting, on the caller's and the clock's. A
 * failing task is logged, and does not affect later ones.
 *
 * <p>Threading: all methods may be called from any thread.
 */
final class ConnectionThread {
    private static final Logger LOG = LoggerFactory.getLogger(RobotConnection.class);
    private static final String NAME = "roomba-connection";
    private static final long END_LIMIT_MILLIS = 2_000;

    private final Clock clock;
    private final @Nullable ExecutorService thread;
    private final Executor own;
    private volatile boolean closed;

    /** @param mayWait whether there is a thread at all */
    ConnectionThread(Clock clock, boolean mayWait) {
        this.clock = clock;
        this.thread = mayWait ? Executors.newSingleThreadExecutor(ConnectionThread::thread) : null;
        this.own = thread != null ? thread : Runnable::run;
    }

    private static Thread thread(Runnable work) {
        Thread made = new Thread(work, NAME);
        made.setDaemon(true);
        return made;
    }

    /**
     * Runs a task and waits for its end.
     *
     * @throws RuntimeException thrown by the task
     */
    void runAndWait(Runnable work) {
        try {
            CompletableFuture.runAsync(work, own).join();
        } catch (CompletionException failure) {
            throw failure.getCause() instanceof RuntimeException cause ? cause : failure;
        }
    }

    /** Runs a task as soon as possible, unless this is closed by then. */
    void run(Runnable work) {
        try {
            own.execute(() -> runUnlessClosed(work));
        } catch (RejectedExecutionException tooLate) {
            LOG.debug("too late: the connection is closed");
        }
    }

    private void runUnlessClosed(Runnable work) {
        if (!closed) {
            try {
                work.run();
            } catch (RuntimeException failure) {
                LOG.error("a task of the connection failed", failure);
            }
        }
    }

    /** Runs a task after a delay, unless this is closed by then. */
    void schedule(Duration delay, Runnable work) {
        if (closed) {
            return;
        }
        try {
            clock.schedule(delay, () -> run(work));
        } catch (RejectedExecutionException noMoreTime) {
            LOG.debug("too late: the clock is closed");
        }
    }

    /** Waits for the current task to end; no further one is run. Idempotent. */
    void close() {
        closed = true;
        if (thread != null) {
            thread.shutdown();
            awaitEnd(thread);
        }
    }

    private static void awaitEnd(ExecutorService ending) {
        try {
            if (!ending.awaitTermination(END_LIMIT_MILLIS, TimeUnit.MILLISECONDS)) {
                LOG.warn("thread {} did not end within {} ms", NAME, END_LIMIT_MILLIS);
            }
        } catch (InterruptedException hurry) {
            Thread.currentThread().interrupt();
        }
    }
}
