package org.evoloop.loop;

import org.jspecify.annotations.Nullable;

/**
 * An analyze, plan or execute component in the loop, with its present work.
 *
 * <p>Threading: work is given by the thread that has the turn or the loop's lock, and given up under the lock; it is
 * run by the thread to which it was given.
 *
 * @param <I> the input of its component
 */
final class StageWorker<I> extends Worker implements CarrierThread.Stage {
    private static final long RETURN_NANOS = 50_000_000;

    /** Calls the component with its input; returns the stage that continues on the same thread, null if none does. */
    interface Work<I> {
        @Nullable
        StageWorker<?> run(StageWorker<I> by, I input) throws Exception;
    }

    /** Whose turn it is. */
    interface Turns {
        /** The component that has the turn; null if none has. May be read without the lock. */
        @Nullable
        StageWorker<?> busy();

        /** Hands the turn on; false if {@code from} was given up meanwhile. */
        boolean pass(StageWorker<?> from, StageWorker<?> next);

        /** Ends the cycle, by a failure if the next component is stuck. */
        void end(StageWorker<?> from, @Nullable StageWorker<?> stuck);

        /** A stage threw; the cycle ends unless it was given up before. */
        void failed(StageWorker<?> worker, Throwable cause);

        /** A stage has returned null, {@code inARow} times in a row; what was given up before has ended already. */
        void returnedNull(StageWorker<?> worker, int inARow);

        /** Begins the next occurrence if nothing is in the loop: the intake may hold one that was not offered. */
        void look();
    }

    private final Work<I> work;
    private final Turns turns;
    private final Crew crew;
    private final @Nullable CarrierThread own;
    private @Nullable I input;
    private long cycle;

    /** How many times in a row it has returned null; for the thread that has the turn. */
    private int nulls;

    /** The cycle in which it was given up and from which it has not returned; 0 if there is none. */
    private volatile long stuckSince;

    /** The thread in which it hangs; null if it does not hang, or in a loop without threads. */
    private volatile @Nullable CarrierThread stuckIn;

    StageWorker(Component component, Crew crew, Turns turns, Work<I> work) {
        super(component);
        this.crew = crew;
        this.turns = turns;
        this.work = work;
        this.own = crew.own(component);
    }

    /** Gives it work. Returns the thread to wake for it; null in a loop without threads. */
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

    /** The cycle of its present work. */
    long cycle() {
        return cycle;
    }

    @Override
    public @Nullable StageWorker<?> runGiven() {
        I given = input;
        if (given == null) {
            return null;
        }
        long givenCycle = cycle;
        input = null;
        try {
            return isStuck() ? null : work.run(this, given);
        } catch (Throwable cause) {
            turns.failed(this, cause);
            return null;
        } finally {
            if (stuckSince == givenCycle) {
                stuckIn = null;
                stuckSince = 0;
                turns.look();
            }
        }
    }

    /**
     * Hands its result on; the cycle ends if that is null or there is no next stage.
     *
     * @return the stage that continues on the caller's thread; null if none does
     */
    <R> @Nullable StageWorker<R> handOn(@Nullable R result, @Nullable StageWorker<R> next) {
        nulls = result == null ? nulls + 1 : 0;
        if (nulls > 0) {
            turns.returnedNull(this, nulls);
        }
        if (result == null || next == null || next.isStuck()) {
            turns.end(this, result == null ? null : next);
            return null;
        }
        // Read now: once the next one has the turn, that may be taken away, and this one be given the next occurrence.
        long inCycle = cycle;
        return turns.pass(this, next) ? next.proceed(inCycle, result) : null;
    }

    /** Returns itself if it is to be run by the caller's thread; null if its own thread runs it. */
    private @Nullable StageWorker<I> proceed(long givenCycle, I givenInput) {
        cycle = givenCycle;
        input = givenInput;
        if (own == null) {
            return this;
        }
        own.give(this);
        own.wake();
        return null;
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

    /** Gives an interrupted component a moment to return, so that the next occurrence does not find it stuck. */
    void letReturn() {
        long deadline = System.nanoTime() + RETURN_NANOS;
        while (stuckIn != null && System.nanoTime() < deadline) {
            LoopThread.giveWay();
        }
    }

    @Override
    boolean isWorking() {
        return turns.busy() == this;
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
