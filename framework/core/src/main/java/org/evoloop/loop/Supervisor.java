package org.evoloop.loop;

import java.time.Duration;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Gives up components that work on their occurrence for longer than the step limit.
 *
 * <p>Threading: guarded by the loop's lock, but for {@link #stepBegins}; the clock calls while there is work.
 */
final class Supervisor<O> {
    /** Whose turn it is, and how it is taken away. */
    interface Turns<O> {
        /** The component that has the turn; null if none has. */
        @Nullable
        StageWorker<?> busy();

        /**
         * Takes the turn from a component that does not return; the lock is held, and {@link #proceedWithout} has to
         * follow. Returns null if it no longer has the turn.
         */
        @Nullable
        Failure<O> giveUp(StageWorker<?> worker, String why);

        /** Reports that {@code late} was given up, and begins the next occurrence; the lock is not held. */
        void proceedWithout(StageWorker<?> late, @Nullable Failure<O> failure);
    }

    private final Turns<O> turns;
    private final LoopLock lock;
    private final Clock clock;
    private final Duration limit;
    private final boolean watches;
    private volatile long begunNanos;
    private boolean scheduled;

    Supervisor(LoopConfig config, Turns<O> turns, LoopLock lock) {
        this.turns = turns;
        this.lock = lock;
        this.clock = config.clock();
        this.limit = config.stepLimit();
        this.watches = config.threads();
    }

    /** The turn is about to go to the next component. Called beforehand, so that no limit covers two of them. */
    void stepBegins() {
        if (watches) {
            begunNanos = clock.nanoTime();
        }
    }

    /** An occurrence has begun; the lock is held. */
    void begun() {
        stepBegins();
        if (watches && !scheduled) {
            scheduled = true;
            clock.schedule(limit, this::look);
        }
    }

    private void look() {
        StageWorker<?> late = null;
        Failure<O> failure = null;
        lock.acquire();
        try {
            StageWorker<?> busy = turns.busy();
            if (busy == null) {
                scheduled = false;
                return;
            }
            long left = limit.toNanos() - (clock.nanoTime() - begunNanos);
            if (left <= 0) {
                failure = turns.giveUp(busy, "has not returned for " + limit.toMillis() + " ms");
                late = failure == null ? null : busy;
                left = limit.toNanos();
            }
            clock.schedule(Duration.ofNanos(left), this::look);
        } finally {
            lock.release();
        }
        if (late != null) {
            turns.proceedWithout(late, failure);
        }
    }
}
