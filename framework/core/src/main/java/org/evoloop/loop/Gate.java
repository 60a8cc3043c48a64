package org.evoloop.loop;

import java.time.Duration;
import org.evoloop.time.OwnedThread;

/**
 * Opens and closes the loop, and holds the next occurrence back while the loop is changed.
 *
 * <p>Threading: called by one thread at a time, never one of the loop's own.
 */
final class Gate<O> {
    private final LoopConfig config;
    private final Sequencer<O> sequencer;
    private final LoopLock lock;

    Gate(LoopConfig config, Sequencer<O> sequencer, LoopLock lock) {
        this.config = config;
        this.sequencer = sequencer;
        this.lock = lock;
    }

    /** Moves to another state. The change itself is up to the caller. */
    void become(LoopState next) {
        lock.acquire();
        try {
            sequencer.become(next);
        } finally {
            sequencer.release();
        }
    }

    /** Closes the loop if it is open; for any thread, at any time. */
    void shut() {
        lock.acquire();
        try {
            if (sequencer.state() == LoopState.RUNNING) {
                sequencer.become(LoopState.STOPPED);
            }
        } finally {
            sequencer.release();
        }
    }

    /** Opens the loop; the first occurrence waits until {@code beginning} has run. */
    void open(Runnable beginning) {
        hold(true);
        try {
            become(LoopState.RUNNING);
            beginning.run();
        } finally {
            hold(false);
        }
    }

    private void hold(boolean held) {
        lock.acquire();
        try {
            sequencer.hold(held);
        } finally {
            sequencer.release();
        }
    }

    /**
     * Changes the loop between two occurrences. The one in the loop may finish within the join limit; then it is given
     * up.
     */
    void quietly(Runnable change) {
        quietly(false, change);
    }

    /**
     * As {@link #quietly}, unless the caller is a function, or another thread that someone waits for, and is asked to
     * end meanwhile.
     *
     * @throws IllegalStateException if it was asked to end; nothing was changed
     */
    void quietlyUnlessInterrupted(Runnable change) {
        quietly(Thread.currentThread() instanceof OwnedThread, change);
    }

    /**
     * Runs {@code change} while no occurrence is in the loop and none begins; nothing is given up for it.
     *
     * @param limit how long to wait for the occurrence in the loop
     * @return whether it ended in time; if not, nothing was changed
     */
    boolean between(Duration limit, Runnable change) {
        boolean interrupted = false;
        boolean quiet;
        lock.acquire();
        try {
            sequencer.hold(true);
            interrupted =
                    config.threads() && sequencer.awaitQuiet(limit, Thread.currentThread() instanceof OwnedThread);
            quiet = sequencer.isQuiet();
        } finally {
            sequencer.release();
        }
        try {
            if (quiet) {
                change.run();
            }
        } finally {
            hold(false);
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
        return quiet;
    }

    private void quietly(boolean impatient, Runnable change) {
        StageWorker<?> late = null;
        Failure<O> failure = null;
        boolean interrupted = false;
        lock.acquire();
        try {
            sequencer.hold(true);
            interrupted = config.threads() && sequencer.awaitQuiet(config.joinLimit(), impatient);
            if (impatient && interrupted && sequencer.busy() != null) {
                throw new IllegalStateException("the loop " + config.name() + " was not changed: "
                        + Thread.currentThread().getName() + " was interrupted");
            }
            String why = config.threads()
                    ? "was interrupted: it did not return within "
                            + config.joinLimit().toMillis() + " ms"
                    : "was given up: the loop was changed by what it called";
            do {
                late = sequencer.busy();
                failure = late == null ? null : sequencer.giveUp(late, why);
            } while (late != null && failure == null);
            change.run();
        } finally {
            sequencer.hold(false);
            sequencer.release();
            // Also after a refused change: work that was given up for it must be reported, or nothing else begins.
            if (late != null) {
                sequencer.proceedWithout(late, failure);
            }
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }
}
