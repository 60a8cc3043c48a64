package org.evoloop.loop;

import java.time.Duration;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.jspecify.annotations.Nullable;

/**
 * The order of the loop: the queue before it, the one occurrence that is in it, and whose turn it is.
 *
 * <p>All of it is guarded by one lock, which is never held while a component or a listener runs. A cycle that was given
 * up has another number than the current one, so whatever its component still returns is ignored.
 */
final class Sequencer<O> {
    private static final int TRIES = 10;

    private final LoopConfig config;
    private final LoopListener<O> listener;
    private final ReentrantLock lock = new ReentrantLock();
    private final Condition quiet = lock.newCondition();
    private final Condition room = lock.newCondition();

    private final Intake<O> intake;
    private volatile LoopState state = LoopState.NEW;
    private boolean paused;
    private boolean breakingOff;
    private boolean stepping;
    private @Nullable StageWorker<O> analyze;
    private long cycle;
    private @Nullable O occurrence;
    /** Changed under the lock; whose turn it is may be read without. */
    private volatile @Nullable StageWorker<?> busy;

    private long busySinceNanos;
    private boolean watched;

    /** Whose slot was filled under the lock; woken when that is given back. */
    private @Nullable StageWorker<?> given;

    Sequencer(LoopConfig config, LoopListener<O> listener, Intake<O> intake) {
        this.config = config;
        this.listener = listener;
        this.intake = intake;
    }

    private void acquire() {
        // Whoever holds it gives it back at once: a thread that slept for it would come much later.
        for (int tries = 0; tries < TRIES; tries++) {
            if (lock.tryLock()) {
                return;
            }
            Worker.giveWay();
        }
        lock.lock();
    }

    private void release() {
        StageWorker<?> next = given;
        given = null;
        lock.unlock();
        if (next != null) {
            next.wake();
        }
    }

    /** Queues an occurrence; false if the loop is closed, or the queue full and the occurrence one that may be lost. */
    boolean offer(O offered) {
        Intake.Admission admission = intake.atOnce(offered);
        if (admission == null) {
            acquire();
            try {
                admission = intake.offer(offered);
                begin();
            } finally {
                release();
            }
        }
        if (admission == Intake.Admission.DROPPED || admission == Intake.Admission.FIRST_DROPPED) {
            listener.dropped(offered, admission == Intake.Admission.FIRST_DROPPED);
        }
        return admission == Intake.Admission.TAKEN;
    }

    /** Queues an occurrence, waiting for room if it must; false if the loop closes meanwhile. */
    boolean put(O offered) throws InterruptedException {
        lock.lockInterruptibly();
        try {
            // Without threads nobody would make room.
            while (config.threads() && state == LoopState.RUNNING && !intake.hasRoom()) {
                room.await();
            }
            Intake.Admission admission = intake.offer(offered);
            begin();
            return admission == Intake.Admission.TAKEN;
        } finally {
            release();
        }
    }

    /** Starts the next cycle if there is something to do and nothing in the way; the lock is held. */
    private void begin() {
        StageWorker<O> first = analyze;
        boolean mayBegin =
                busy == null && !breakingOff && !paused && state == LoopState.RUNNING && (config.threads() || stepping);
        O next = mayBegin && first != null ? intake.next() : null;
        if (next != null && first != null) {
            room.signal();
            cycle++;
            occurrence = next;
            hand(first, next);
        }
    }

    private <I> void hand(StageWorker<I> worker, I input) {
        busy = worker;
        worker.give(cycle, input);
        if (!config.threads()) {
            return;
        }
        given = worker;
        busySinceNanos = config.clock().nanoTime();
        if (!watched) {
            watched = true;
            config.clock().schedule(config.stepLimit(), this::watch);
        }
    }

    /** Hands the result of a stage on; a null result or nobody to take it ends the cycle. */
    <I> void passOn(long fromCycle, @Nullable I result, @Nullable StageWorker<I> next) {
        Failure<O> failure = null;
        acquire();
        try {
            if (fromCycle != cycle || busy == null) {
                return;
            }
            if (result == null || next == null) {
                endCycle();
            } else if (next.isStuck()) {
                failure = breakOff(next, "is stuck in its thread " + next.threadName() + "; exchange it");
            } else {
                hand(next, result);
            }
        } finally {
            release();
        }
        goOn(next, failure);
    }

    private void endCycle() {
        busy = null;
        occurrence = null;
        intake.ended();
        quiet.signalAll();
        begin();
        if (busy == null) {
            room.signal();
        }
    }

    /**
     * Takes the occurrence out of the loop, from whatever component has it. The next one does not begin before the
     * failure was reported, see {@link #goOn}: the listener may have to put things in order first.
     */
    private Failure<O> breakOff(Worker worker, String what) {
        Failure<O> failure = new Failure<>(
                worker.component().name(), worker.roleName(), cycle, occurrence, new TimeoutException(what));
        breakingOff = true;
        busy = null;
        return failure;
    }

    private void goOn(@Nullable Worker worker, @Nullable Failure<O> failure) {
        if (failure != null && worker != null) {
            worker.countFailure(failure.toString());
            listener.givenUp(failure);
            acquire();
            try {
                breakingOff = false;
                endCycle();
            } finally {
                release();
            }
        }
    }

    /** A stage threw; the cycle ends unless it was given up before. */
    void failed(Worker worker, long inCycle, Throwable cause) {
        O about;
        acquire();
        try {
            if (inCycle != cycle || busy == null) {
                return;
            }
            about = occurrence;
        } finally {
            release();
        }
        report(worker, worker.roleName(), inCycle, about, cause);
        passOn(inCycle, null, null);
    }

    void report(Worker worker, String phase, long inCycle, @Nullable O about, Throwable cause) {
        Failure<O> failure = new Failure<>(worker.component().name(), phase, inCycle, about, cause);
        worker.countFailure(failure.toString());
        listener.failed(failure);
    }

    /** Gives a component up that has worked on its occurrence for too long; called by the clock while there is work. */
    private void watch() {
        StageWorker<?> late = null;
        Failure<O> failure = null;
        acquire();
        try {
            if (busy == null) {
                watched = false;
                return;
            }
            long left = config.stepLimit().toNanos() - (config.clock().nanoTime() - busySinceNanos);
            if (left <= 0) {
                late = busy;
                failure = giveUp(
                        late, "has not returned for " + config.stepLimit().toMillis() + " ms");
                left = config.stepLimit().toNanos();
            }
            config.clock().schedule(Duration.ofNanos(left), this::watch);
        } finally {
            release();
        }
        goOn(late, failure);
    }

    private Failure<O> giveUp(StageWorker<?> worker, String why) {
        worker.setStuck(true);
        worker.interrupt();
        return breakOff(worker, why);
    }

    /**
     * Changes the loop between two occurrences. The one that is in the loop may finish within the join limit; then it is
     * given up.
     */
    void quietly(Runnable change) {
        StageWorker<?> late = null;
        Failure<O> failure = null;
        boolean interrupted = false;
        acquire();
        try {
            paused = true;
            interrupted = awaitQuiet();
            late = busy;
            if (late != null) {
                failure = giveUp(
                        late,
                        config.threads()
                                ? "was interrupted: it did not return within "
                                        + config.joinLimit().toMillis() + " ms"
                                : "was given up: the loop was changed by what it called");
            }
            change.run();
        } finally {
            paused = false;
            begin();
            release();
            // Also after a change that was refused: what was given up for it must be reported, or nothing else begins.
            if (late != null) {
                late.letReturn();
            }
            goOn(late, failure);
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    private boolean awaitQuiet() {
        boolean interrupted = false;
        long left = config.joinLimit().toNanos();
        while ((busy != null || breakingOff) && left > 0 && config.threads()) {
            try {
                left = quiet.awaitNanos(left);
            } catch (InterruptedException e) {
                interrupted = true;
            }
        }
        return interrupted;
    }

    /** Moves to another state; waiting putters look again. The change itself is up to the caller. */
    void become(LoopState next) {
        acquire();
        try {
            state = next;
            room.signalAll();
            if (next == LoopState.RUNNING) {
                intake.opened();
            } else {
                intake.closed();
            }
            begin();
        } finally {
            release();
        }
    }

    /** Opens the loop; the first occurrence waits until {@code beginning} has run. */
    void open(Runnable beginning) {
        pause(true);
        try {
            become(LoopState.RUNNING);
            beginning.run();
        } finally {
            pause(false);
        }
    }

    private void pause(boolean nowPaused) {
        acquire();
        try {
            paused = nowPaused;
            begin();
        } finally {
            release();
        }
    }

    /** Called by a change that goes on {@link #quietly}. */
    void setAnalyze(@Nullable StageWorker<O> worker) {
        analyze = worker;
    }

    /** Runs one cycle on the caller's thread; false if nothing waited. */
    boolean step() {
        acquire();
        try {
            stepping = true;
            begin();
        } finally {
            stepping = false;
            release();
        }
        boolean worked = false;
        for (StageWorker<?> turn = busy; turn != null; turn = busy) {
            turn.runGiven();
            worked = true;
        }
        return worked;
    }

    LoopState state() {
        return state;
    }

    QueueStatus queueStatus() {
        acquire();
        try {
            return intake.status();
        } finally {
            release();
        }
    }
}
