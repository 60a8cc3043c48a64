package org.evoloop.loop;

import java.time.Duration;
import org.evoloop.time.Clock;

/**
 * Gives up components that work on their occurrence for longer than the step limit.
 *
 * <p>Threading: guarded by the loop's lock, but for {@link #stepBegins}; the clock calls while there is work.
 */
final class Supervisor<O> {
    private final Sequencer<O> sequencer;
    private final LoopLock lock;
    private final Clock clock;
    private final Duration limit;
    private final boolean watches;
    private volatile long begunNanos;
    private boolean scheduled;

    Supervisor(LoopConfig config, Sequencer<O> sequencer, LoopLock lock) {
        this.sequencer = sequencer;
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
            StageWorker<?> busy = sequencer.busy();
            if (busy == null) {
                scheduled = false;
                return;
            }
            long left = limit.toNanos() - (clock.nanoTime() - begunNanos);
            if (left <= 0) {
                failure = sequencer.giveUp(busy, "has not returned for " + limit.toMillis() + " ms");
                late = failure == null ? null : busy;
                left = limit.toNanos();
            }
            clock.schedule(Duration.ofNanos(left), this::look);
        } finally {
            lock.release();
        }
        if (late != null) {
            sequencer.proceedWithout(late, failure);
        }
    }
}
