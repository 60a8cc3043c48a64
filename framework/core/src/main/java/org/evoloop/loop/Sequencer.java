package org.evoloop.loop;

import java.time.Duration;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicReferenceFieldUpdater;
import java.util.concurrent.locks.Condition;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The order of the loop: the queue before it, the one occurrence that is in it, and whose turn it is.
 *
 * <p>Everything is guarded by the loop's lock, except one move: the component that has the turn hands it to the next
 * one without the lock. Taking the turn away replaces it by the same atomic operation, so one of the two comes too late
 * and does nothing: the result of a component that was given up is ignored.
 */
final class Sequencer<O> implements StageWorker.Turns, Supervisor.Turns<O> {
    // Unlike an atomic reference, it is fast before it has been compiled, which matters for rare events.
    @SuppressWarnings("rawtypes") // a class literal has no type arguments
    private static final AtomicReferenceFieldUpdater<Sequencer, StageWorker> TURN =
            AtomicReferenceFieldUpdater.newUpdater(Sequencer.class, StageWorker.class, "busy");

    /** The loop logs under one name. */
    private static final Logger LOG = LoggerFactory.getLogger("org.evoloop.loop.MapeLoop");

    private final LoopConfig config;
    private final LoopListener<O> listener;
    private final Intake<O> intake;
    private final LoopLock lock;
    private final Condition ended;
    private final Condition room;
    private final Supervisor<O> supervisor;
    private final Pipeline<O, ?, ?> pipeline;

    private volatile LoopState state = LoopState.NEW;
    private boolean held;
    private boolean breakingOff;
    private boolean stepping;
    private long cycle;
    private @Nullable O occurrence;
    private volatile @Nullable StageWorker<?> busy;

    /** An occurrence that came to a stuck analyze component; reported after the lock is released. */
    private @Nullable Failure<O> refused;

    Sequencer(
            LoopConfig config, LoopListener<O> listener, Intake<O> intake, Pipeline<O, ?, ?> pipeline, LoopLock lock) {
        this.config = config;
        this.listener = listener;
        this.intake = intake;
        this.pipeline = pipeline;
        this.lock = lock;
        this.ended = lock.newCondition();
        this.room = lock.newCondition();
        this.supervisor = new Supervisor<>(config, this, lock);
    }

    // What occurs

    /** Queues an occurrence, unless it is refused, or the queue is full and the occurrence one that may be lost. */
    Intake.Admission offer(O offered) {
        Intake.Admission admission = intake.atOnce(offered);
        if (admission == null) {
            lock.acquire();
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
        return admission;
    }

    /** Queues an occurrence, waiting for room if it must; false if the loop closes meanwhile. */
    boolean put(O offered) throws InterruptedException {
        lock.acquireInterruptibly();
        try {
            // Without threads, nothing would make room.
            while (config.threads() && state == LoopState.RUNNING && !intake.hasRoom(offered)) {
                room.await();
            }
            Intake.Admission admission = intake.offer(offered);
            begin();
            return admission == Intake.Admission.TAKEN;
        } finally {
            release();
        }
    }

    @Override
    public void look() {
        lock.acquire();
        try {
            begin();
        } finally {
            release();
        }
    }

    // Turns

    /** Starts the next cycle if something waits and nothing prevents it; the lock is held. */
    private void begin() {
        StageWorker<O> first = pipeline.first();
        boolean mayBegin =
                busy == null && !breakingOff && !held && state == LoopState.RUNNING && (config.threads() || stepping);
        O next = mayBegin && first != null ? intake.next() : null;
        if (next == null || first == null) {
            return;
        }
        // All: there may be room for another than the one who has waited longest.
        room.signalAll();
        cycle++;
        occurrence = next;
        if (first.isStuck()) {
            refused = breakOff(first, stuck(first));
            return;
        }
        busy = first;
        // Before the work is given: a thread that is awake takes it at once, and its time runs from then on.
        supervisor.begun();
        CarrierThread carrier = first.give(cycle, next);
        if (carrier != null) {
            lock.wakeAfterRelease(carrier);
        }
    }

    @Override
    public boolean pass(StageWorker<?> from, StageWorker<?> next) {
        // One that was given up must not give more time to the one that has the turn now.
        if (busy == from) {
            supervisor.stepBegins();
            if (TURN.compareAndSet(this, from, next)) {
                return true;
            }
        }
        // It is marked as stuck under the lock, and must see that before it returns.
        lock.acquire();
        lock.release();
        return false;
    }

    @Override
    public void end(StageWorker<?> from, @Nullable StageWorker<?> stuck) {
        Failure<O> failure = null;
        lock.acquire();
        try {
            if (!TURN.compareAndSet(this, from, null)) {
                return;
            }
            if (stuck == null) {
                endCycle();
            } else {
                failure = breakOff(stuck, stuck(stuck));
            }
        } finally {
            release();
        }
        if (stuck != null) {
            proceedAfter(stuck, failure);
        }
    }

    private void endCycle() {
        occurrence = null;
        intake.ended();
        ended.signalAll();
        begin();
        if (busy == null) {
            room.signalAll();
        }
    }

    /** Runs one cycle on the caller's thread; false if nothing waited. */
    boolean step() {
        StageWorker<?> first;
        lock.acquire();
        try {
            stepping = busy == null;
            begin();
            first = stepping ? busy : null;
        } finally {
            stepping = false;
            release();
        }
        StageWorker<?> turn = first;
        while (turn != null) {
            turn = turn.runGiven();
        }
        return first != null;
    }

    // Failures

    @Override
    public void failed(StageWorker<?> worker, Throwable cause) {
        O about;
        lock.acquire();
        try {
            if (busy != worker) {
                return;
            }
            about = occurrence;
        } finally {
            release();
        }
        report(worker, worker.roleName(), worker.cycle(), about, cause);
        end(worker, null);
    }

    @Override
    public void returnedNull(StageWorker<?> worker, int inARow) {
        O about;
        lock.acquire();
        try {
            about = busy == worker ? occurrence : null;
        } finally {
            release();
        }
        if (about != null) {
            listener.returnedNull(worker.component().name(), worker.roleName(), inARow, about);
        }
    }

    void report(Worker worker, String phase, long inCycle, @Nullable O about, Throwable cause) {
        Failure<O> failure = new Failure<>(worker.component().name(), phase, inCycle, about, cause);
        worker.countFailure(failure.toString());
        tell(failure, listener::failed);
    }

    /** Tells the listener of a failure. It must not throw; if it does, the loop goes on all the same. */
    private void tell(Failure<O> failure, Consumer<Failure<O>> how) {
        try {
            how.accept(failure);
        } catch (Throwable broken) {
            LOG.error("the listener of the loop {} has failed when told of {}", config.name(), failure, broken);
        }
    }

    private static String stuck(Worker worker) {
        return "is stuck in its thread " + worker.threadName() + "; exchange it";
    }

    @Override
    public @Nullable Failure<O> giveUp(StageWorker<?> worker, String why) {
        if (!TURN.compareAndSet(this, worker, null)) {
            return null;
        }
        worker.giveUp(cycle);
        return breakOff(worker, why);
    }

    /**
     * Takes the occurrence out of the loop. The next one does not begin before the failure has been reported, see
     * {@link #proceedAfter}: the listener may have to clean up first.
     */
    private Failure<O> breakOff(Worker worker, String what) {
        Failure<O> failure = new Failure<>(
                worker.component().name(), worker.roleName(), cycle, occurrence, new TimeoutException(what));
        breakingOff = true;
        return failure;
    }

    @Override
    public void proceedWithout(StageWorker<?> late, @Nullable Failure<O> failure) {
        // The next occurrence may need the same component, for example to find out whether its step had its effect.
        late.letReturn();
        proceedAfter(late, failure);
    }

    /** Reports the failure and begins the next occurrence; the lock is not held. */
    void proceedAfter(Worker worker, @Nullable Failure<O> failure) {
        Worker about = worker;
        Failure<O> next = failure;
        while (next != null && about != null) {
            about.countFailure(next.toString());
            tell(next, listener::givenUp);
            lock.acquire();
            try {
                breakingOff = false;
                endCycle();
            } finally {
                about = pipeline.first();
                next = takeRefused();
                lock.release();
            }
        }
    }

    private @Nullable Failure<O> takeRefused() {
        Failure<O> taken = refused;
        refused = null;
        return taken;
    }

    /** Releases the lock, and reports an occurrence that came to a stuck component. */
    void release() {
        Worker first = pipeline.first();
        Failure<O> failure = takeRefused();
        lock.release();
        if (failure != null && first != null) {
            proceedAfter(first, failure);
        }
    }

    // Changes; the lock is held

    @Override
    public @Nullable StageWorker<?> busy() {
        return busy;
    }

    /**
     * Waits until no occurrence is in the loop. Returns whether the caller was interrupted meanwhile.
     *
     * @param impatient whether an interrupt cuts the wait short
     */
    boolean awaitQuiet(Duration limit, boolean impatient) {
        boolean interrupted = false;
        long left = limit.toNanos();
        while (!isQuiet() && left > 0) {
            try {
                left = ended.awaitNanos(left);
            } catch (InterruptedException e) {
                interrupted = true;
                if (impatient) {
                    break;
                }
            }
        }
        return interrupted;
    }

    /** Whether no occurrence is in the loop. */
    boolean isQuiet() {
        return busy == null && !breakingOff;
    }

    /** Holds or releases the loop; while it is held, nothing begins. */
    void hold(boolean nowHeld) {
        held = nowHeld;
        begin();
    }

    /** Moves to another state; threads that wait for room check again. */
    void become(LoopState next) {
        state = next;
        room.signalAll();
        if (next == LoopState.RUNNING) {
            intake.opened();
        } else {
            intake.closed();
        }
        begin();
    }

    LoopState state() {
        return state;
    }

    QueueStatus queueStatus() {
        lock.acquire();
        try {
            return intake.status();
        } finally {
            lock.release();
        }
    }
}
