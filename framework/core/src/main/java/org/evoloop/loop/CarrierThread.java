package org.evoloop.loop;

import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;

/** A thread that runs analyze, plan and execute components: the one whose turn it is stands in its slot. */
final class CarrierThread extends LoopThread {
    private final WaitStrategy waiting;
    // Volatile fields, not atomic ones: a press seldom comes, and what those go through is interpreted by then.
    private volatile @Nullable StageWorker<?> slot;
    private volatile boolean asleep;

    /** Whether its turn came soon the last time, so that it is worth staying awake. The thread's own. */
    private boolean patient = true;

    CarrierThread(Object owner, String name, WaitStrategy waiting) {
        super(owner, name);
        this.waiting = waiting;
    }

    /** Puts a component that was given work into the slot, which must be empty; {@link #wake} has to follow. */
    void give(StageWorker<?> stage) {
        slot = stage;
    }

    /** Wakes the thread if it sleeps. */
    void wake() {
        if (hasToBeWoken()) {
            unpark();
        }
    }

    /** Whether the thread might not see by itself what was put into its slot. */
    boolean hasToBeWoken() {
        // The slot was filled before the flag is read; with the same order in maySleep(), one of the two sees the
        // other.
        return asleep;
    }

    @Override
    void round() throws InterruptedException {
        int rounds = patient ? waiting.looks() + waiting.yields() : 0;
        for (int round = 0; round < rounds && isIdle(); round++) {
            if (round < waiting.looks()) {
                Thread.onSpinWait();
            } else {
                giveWay();
            }
        }
        if (isIdle()) {
            long begun = System.nanoTime();
            while (isIdle()) {
                sleep();
            }
            patient = System.nanoTime() - begun < WaitStrategy.SOON_NANOS;
        }
        // An interrupt that is still pending was meant for work that was given up, unless the thread itself shall end.
        boolean interrupted = Thread.interrupted();
        if (!(interrupted && isRetired())) {
            runGiven();
        }
    }

    private boolean isIdle() {
        return slot == null && !isRetired();
    }

    /** Says that the thread is about to sleep; whether there is still nothing to do. */
    boolean maySleep() {
        asleep = true;
        return isIdle();
    }

    private void sleep() throws InterruptedException {
        if (maySleep()) {
            LockSupport.park(this);
        }
        asleep = false;
        if (Thread.interrupted()) {
            throw new InterruptedException();
        }
    }

    /** Runs what is in the slot, if anything is, and whatever goes on on this thread. */
    void runGiven() {
        StageWorker<?> stage = slot;
        if (stage != null) {
            slot = null;
        }
        while (stage != null) {
            stage = stage.runGiven();
            // One component's interrupt is none of the next one's.
            Thread.interrupted();
        }
    }

    /** What is left in the slot was given up, for the thread would not have been retired before; so it is not run. */
    @Override
    void ended() {
        runGiven();
    }
}
