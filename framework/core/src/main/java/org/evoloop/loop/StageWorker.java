package org.evoloop.loop;

import org.jspecify.annotations.Nullable;

/**
 * An analyze, plan or execute component in the loop, with the piece of work that it was given.
 *
 * <p>Threading: given work by whoever has the turn or the loop's lock, and given up under that; run by the thread that it was
 * given to.
 *
 * @param <I> what its component works on
 */
final class StageWorker<I> extends Worker {
    private static final long RETURN_NANOS = 50_000_000;

    /** What the component does with its input; tells who goes on on the same thread, null if nobody does. */
    interface Work<I> {
        @Nullable
        StageWorker<?> run(StageWorker<I> by, I input) throws Exception;
    }

    private final Work<I> work;
    private final Sequencer<?> sequencer;
    private final Crew crew;
    private final @Nullable CarrierThread own;
    private @Nullable I input;
    private long cycle;

    /** How often in a row it has returned null; for whoever has the turn. */
    private int nulls;

    /** The cycle in which it was given up and has not returned from since; 0 if there is none. */
    private volatile long stuckSince;

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
        CarrierThread by = carrier();
        if (by != null) {
            by.give(this);
        }
        return by;
    }

    private @Nullable CarrierThread carrier() {
        return own == null ? crew.shared() : own;
    }

    /**
     * Gives it what the component before it has made.
     *
     * @return itself if it is to be run by the caller's thread; null if its own thread runs it
     */
    @Nullable
    StageWorker<I> goOn(long givenCycle, I givenInput) {
        cycle = givenCycle;
        input = givenInput;
        if (own == null) {
            return this;
        }
        own.give(this);
        own.wake();
        return null;
    }

    /** The cycle in which it was given its work. */
    long cycle() {
        return cycle;
    }

    /** It has returned null, or something. Tells how often in a row it has returned null. */
    int countNull(boolean isNull) {
        nulls = isNull ? nulls + 1 : 0;
        return nulls;
    }

    /**
     * Does the work that it was given, on the caller's thread, unless that was given up before it was begun.
     *
     * @return who goes on on this thread; null if nobody does
     */
    @Nullable
    StageWorker<?> runGiven() {
        I given = input;
        if (given == null) {
            return null;
        }
        long givenCycle = cycle;
        input = null;
        try {
            return isStuck() ? null : work.run(this, given);
        } catch (Throwable cause) {
            sequencer.failed(this, cause);
            return null;
        } finally {
            if (stuckSince == givenCycle) {
                stuckIn = null;
                stuckSince = 0;
            }
        }
    }

    /** Its work was given up: it counts as stuck until it returns, and its thread is interrupted. */
    void giveUp(long inCycle) {
        CarrierThread late = carrier();
        stuckIn = late;
        stuckSince = inCycle;
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
        return sequencer.busy() == this;
    }

    @Override
    boolean isStuck() {
        return stuckSince != 0;
    }

    @Override
    @Nullable
    LoopThread thread() {
        CarrierThread hangs = stuckIn;
        return hangs != null ? hangs : own != null ? own : crew.shared();
    }

    @Override
    @Nullable
    LoopThread ownThread() {
        return own;
    }

    @Override
    @Nullable
    LoopThread threadToEnd() {
        return own != null ? own : stuckIn;
    }
}
