package org.evoloop.loop;

import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;

/** A thread that runs analyze, plan and execute components: its slot holds the one whose turn it is. */
final class CarrierThread extends LoopThread {
    /** How long it stays awake for work that it was roused for: longer than it takes to decide on an occurrence. */
    private static final long ROUSED_NANOS = 200_000;

    private final WaitStrategy waiting;
    // Volatile fields, not atomic objects: events are rare, so the code of those would still be interpreted.
    private volatile @Nullable StageWorker<?> slot;
    private volatile boolean asleep;
    private volatile boolean roused;

    /** Whether it was last roused for nothing; then it is not, until it has worked again. */
    private volatile boolean disappointed;

    private volatile @Nullable CarrierThread follower;

    /** Whether its turn came soon last time, so that it is worth staying awake. Used by the thread itself only. */
    private boolean patient = true;

    CarrierThread(Object owner, String name, WaitStrategy waiting) {
        super(owner, name);
        this.waiting = waiting;
    }

    /** Puts a component that was given work into the slot, which must be empty; {@link #wake} has to follow. */
    void give(StageWorker<?> stage) {
        slot = stage;
    }

    /** Sets the thread that usually works next. */
    void precede(@Nullable CarrierThread next) {
        follower = next;
    }

    /**
     * Wakes the thread if it sleeps, and those that follow it, since there will probably be work soon: it takes a thread
     * as long to wake up as it takes to decide on an occurrence.
     */
    void rouse() {
        if (asleep && !disappointed) {
            roused = true;
            unpark();
        }
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
                if (isRoused()) {
                    lookOut();
                }
            }
            patient = System.nanoTime() - begun < WaitStrategy.SOON_NANOS;
        }
        // A pending interrupt was meant for work that was given up, unless the thread itself is to end.
        boolean interrupted = Thread.interrupted();
        if (!(interrupted && isRetired())) {
            runGiven();
        }
    }

    /** Whether it was roused and has not looked out for its work yet. */
    boolean isRoused() {
        return roused;
    }

    /** Stays awake for a moment, in which its work should come. */
    void lookOut() {
        CarrierThread next = follower;
        if (next != null) {
            next.rouse();
        }
        long end = System.nanoTime() + ROUSED_NANOS;
        while (isIdle() && System.nanoTime() < end) {
            giveWay();
        }
        disappointed = isIdle();
        roused = false;
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
        StageWorker<?> stage = slot;
        if (stage != null) {
            slot = null;
            if (disappointed) {
                disappointed = false;
            }
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
