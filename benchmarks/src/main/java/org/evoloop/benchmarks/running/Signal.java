package org.evoloop.benchmarks.running;

import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;

/**
 * Lets one thread wait for another. Unlike the JDK's classes it allocates nothing, since allocation is measured here.
 *
 * <p>Threading: one thread waits, any thread sets.
 */
final class Signal {
    private volatile boolean set;
    private volatile @Nullable Thread waiter;

    void set() {
        set = true;
        LockSupport.unpark(waiter);
    }

    void clear() {
        set = false;
    }

    /** Waits until the signal is set, and clears it. */
    void await() throws InterruptedException {
        waiter = Thread.currentThread();
        while (!set) {
            LockSupport.park(this);
            if (Thread.interrupted()) {
                throw new InterruptedException();
            }
        }
        clear();
    }
}
