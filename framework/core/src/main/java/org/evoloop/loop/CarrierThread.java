package org.evoloop.loop;

import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;

/** A thread that runs analyze, plan and execute components: its slot holds the one whose turn it is. */
final class CarrierThread extends LoopThread {
    /** A component that was given work. */
    interface Stage {
        /**
         * Does the work on the caller's thread, unless that was given up before it began.
         *
         * @return the stage that continues on this thread; null if none does
         */
        @Nullable
        Stage runGiven();
    }

    private final WaitStrategy waiting;
    // Volatile fields, not atomic objects: events are rare, so the code of those would still be interpreted.
    private volatile @Nullable Stage slot;
    private volatile boolean asleep;

    /** Whether its turn came soon last time, so that it is worth staying awake. Used by the thread itself only. */
    private boolean patient = true;

    CarrierThread(Object owner, String name, WaitStrategy waiting) {
        super(owner, name);
        this.waiting = waiting;
    }

    /** Puts a component that was given work into the slot, which must be empty; {@link #wake} has to follow. */
    void give(Stage stage) {
        slot = stage;
    }

    /** Wakes the thread if it sleeps. */
    void wake() {
        if (hasToBeWoken()) {
            unpark();
        }
    }

    /** Whether the thread may be asleep and not see its slot being filled. */
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
        // A pending interrupt was meant for work that was given up, unless the thread itself is to end.
        boolean interrupted = Thread.interrupted();
        if (!(interrupted && isRetired())) {
            runGiven();
        }
    }

    private boolean isIdle() {
        return slot == null && !isRetired();
    }

    /** Announces that the thread is about to sleep; returns whether there is still nothing to do. */
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

    /** Runs the component in the slot, if any, and those that follow it on this thread. */
    void runGiven() {
        Stage stage = slot;
        if (stage != null) {
            slot = null;
        }
        while (stage != null) {
            stage = stage.runGiven();
            // An interrupt of one component must not affect the next.
            Thread.interrupted();
        }
    }

    /** Work left in the slot was given up, or the thread would not have been retired; so it is not run. */
    @Override
    void ended() {
        runGiven();
    }
}
