package org.evoloop.loop;

import java.lang.invoke.VarHandle;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;

/**
 * The thread of an analyze, plan or execute component: it takes one piece of work at a time from its slot.
 *
 * <p>Flags that others only read are set without the fence of a volatile write, which would cost more than most of the
 * work between two of them.
 *
 * @param <I> what its component works on
 */
final class StageWorker<I> extends Worker {

    /** What the worker does with its input. */
    interface Work<I> {
        void run(long cycle, I input) throws Exception;
    }

    private final Work<I> work;
    private final Sequencer<?> sequencer;
    private final WaitStrategy waiting;
    private @Nullable I input;
    private long cycle;
    private final AtomicBoolean full = new AtomicBoolean();
    private volatile boolean asleep;
    private final AtomicBoolean working = new AtomicBoolean();

    /** Whether its turn came soon the last time, so that it is worth staying awake. The thread's own. */
    private boolean patient = true;

    StageWorker(Component component, LoopConfig config, Sequencer<?> sequencer, Work<I> work) {
        super(component, config);
        this.sequencer = sequencer;
        this.work = work;
        this.waiting = config.waiting();
    }

    /** Puts a piece of work into the slot, which must be empty; {@link #wake} has to follow. */
    void give(long givenCycle, I givenInput) {
        cycle = givenCycle;
        input = givenInput;
        full.setRelease(true);
    }

    /** Wakes the thread if it sleeps. */
    void wake() {
        // The slot was filled before the flag is read; with the same order in sleep(), one of the two sees the other.
        VarHandle.fullFence();
        if (asleep) {
            unpark();
        }
    }

    @Override
    void work() throws InterruptedException {
        int rounds = patient ? waiting.looks() + waiting.yields() : 0;
        for (int round = 0; round < rounds && !full.get() && !isRetired(); round++) {
            if (round < waiting.looks()) {
                Thread.onSpinWait();
            } else {
                giveWay();
            }
        }
        if (!full.get()) {
            long begun = System.nanoTime();
            while (!full.get()) {
                if (isRetired()) {
                    return;
                }
                sleep();
            }
            patient = System.nanoTime() - begun < WaitStrategy.SOON_NANOS;
        }
        // An interrupt that is still pending was meant for work that was given up, unless the thread itself shall end.
        if (Thread.interrupted() && isRetired()) {
            return;
        }
        runGiven();
    }

    private void sleep() throws InterruptedException {
        asleep = true;
        if (!full.get() && !isRetired()) {
            LockSupport.park(this);
        }
        asleep = false;
        if (Thread.interrupted()) {
            throw new InterruptedException();
        }
    }

    /** Does the work in the slot, on the caller's thread. */
    void runGiven() {
        I given = input;
        if (given == null) {
            return;
        }
        long givenCycle = cycle;
        input = null;
        full.setRelease(false);
        working.setRelease(true);
        try {
            work.run(givenCycle, given);
        } catch (Throwable cause) {
            sequencer.failed(this, givenCycle, cause);
        } finally {
            working.setRelease(false);
            if (isStuck()) {
                setStuck(false);
            }
        }
    }

    @Override
    boolean isWorking() {
        return working.get();
    }
}
