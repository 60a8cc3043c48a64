package org.evoloop.loop;

import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.jspecify.annotations.Nullable;

/**
 * The one lock of a loop. It is never held while a component or a listener runs, and a thread that was given work under
 * it is woken after its release: a thread that woke up to find it taken would have to wait again.
 */
final class LoopLock {
    private static final int TRIES = 10;

    private final ReentrantLock lock = new ReentrantLock();
    private @Nullable CarrierThread given;

    void acquire() {
        // It is held only briefly: a thread that slept for it would get it much later.
        for (int tries = 0; tries < TRIES; tries++) {
            if (lock.tryLock()) {
                return;
            }
            LoopThread.giveWay();
        }
        lock.lock();
    }

    void acquireInterruptibly() throws InterruptedException {
        lock.lockInterruptibly();
    }

    void release() {
        CarrierThread next = given;
        given = null;
        lock.unlock();
        if (next != null && !next.isCurrent()) {
            next.wake();
        }
    }

    /** Notes that this thread was given work. */
    void wakeAfterRelease(CarrierThread carrier) {
        given = carrier;
    }

    Condition newCondition() {
        return lock.newCondition();
    }
}
