package org.evoloop.loop;

import java.util.concurrent.atomic.AtomicBoolean;
import org.jspecify.annotations.Nullable;

/**
 * An analyze, plan or execute component in the loop, with the piece of work that it was given.
 *
 * <p>Threading: given work, and given up, under the loop's lock; run by the thread that it was given to.
 *
 * @param <I> what its component works on
 */
final class StageWorker<I> extends Worker {
    private static final long RETURN_NANOS = 50_000_000;

    /** What the component does with its input. */
    interface Work<I> {
        void run(long cycle, I input) throws Exception;
    }

    private final Work<I> work;
    private final Sequencer<?> sequencer;
    private final Crew crew;
    private final @Nullable CarrierThread own;
    private @Nullable I input;
    private long cycle;

    /** Who has the work. Guarded by the loop's lock. */
    private @Nullable CarrierThread carrier;

    private final AtomicBoolean working = new AtomicBoolean();
    private volatile boolean stuck;

    /** Where it hangs; null if it does not, or in a loop without threads. */
    private volatile @Nullable CarrierThread stuckIn;

    StageWorker(Component component, Crew crew, Sequencer<?> sequencer, Work<I> work) {
        super(component);
        this.crew = crew;
        this.sequencer = sequencer;
        this.work = work;
        this.own = crew.own(component);
    }

    /** Gives it a piece of work. Returns the thread that has to be woken for it, null in a loop without threads. */
    @Nullable
    CarrierThread give(long givenCycle, I givenInput) {
        cycle = givenCycle;
        input = givenInput;
        CarrierThread by = own == null ? crew.shared() : own;
        if (by != null) {
            carrier = by;
            by.give(this);
        }
        return by;
    }

    /** Does the work that it was given, on the caller's thread, unless that was given up before it was begun. */
    void runGiven() {
        I given = input;
        if (given == null) {
            return;
        }
        long givenCycle = cycle;
        input = null;
        working.setRelease(true);
        try {
            if (!stuck) {
                work.run(givenCycle, given);
            }
        } catch (Throwable cause) {
            sequencer.failed(this, givenCycle, cause);
        } finally {
            working.setRelease(false);
            if (stuck) {
                stuckIn = null;
                stuck = false;
            }
        }
    }

    /** Its work was given up: it counts as stuck until it returns, and its thread is interrupted. */
    void giveUp() {
        CarrierThread late = carrier;
        stuckIn = late;
        stuck = true;
        if (late != null) {
            crew.giveUp(late);
        }
    }

    /** Gives a component that was interrupted a moment to return, so that what comes next does not find it stuck. */
    void letReturn() {
        long deadline = System.nanoTime() + RETURN_NANOS;
        while (stuckIn != null && System.nanoTime() < deadline) {
            LoopThread.giveWay();
        }
    }

    @Override
    boolean isWorking() {
        return working.get();
    }

    @Override
    boolean isStuck() {
        return stuck;
    }

    @Override
    @Nullable
    LoopThread thread() {
        CarrierThread hangs = stuckIn;
        return hangs != null ? hangs : own != null ? own : crew.shared();
    }

    @Override
    @Nullable
    LoopThread threadToEnd() {
        return own != null ? own : stuckIn;
    }
}
