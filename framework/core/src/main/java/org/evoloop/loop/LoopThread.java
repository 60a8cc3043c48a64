package org.evoloop.loop;

import java.time.Duration;
import java.util.concurrent.locks.LockSupport;
import org.evoloop.time.OwnedThread;
import org.evoloop.time.Threads;

/** A thread of the loop: it runs one round after another, until it is retired. */
abstract class LoopThread implements Runnable {
    private final Thread thread;
    private volatile boolean retired;

    /** @param owner the crew that it belongs to */
    LoopThread(Object owner, String name) {
        thread = OwnedThread.within(owner, name, this);
    }

    /** One round on this thread; returns when it is time to check whether the thread is still needed. */
    abstract void round() throws InterruptedException;

    /** Called last on this thread. */
    void ended() {}

    @Override
    public final void run() {
        while (!retired) {
            try {
                round();
            } catch (InterruptedException stop) {
                // An interrupt means that the thread is retired or its work is given up; the condition above tells
                // which.
            }
        }
        ended();
    }

    @SuppressWarnings("ThreadPriorityCheck") // a hint only: nothing is wrong if the scheduler ignores it
    static void giveWay() {
        Thread.yield();
    }

    final String name() {
        return thread.getName();
    }

    final void start() {
        thread.start();
    }

    final void interrupt() {
        thread.interrupt();
    }

    final void unpark() {
        LockSupport.unpark(thread);
    }

    final boolean isAlive() {
        return thread.isAlive();
    }

    final boolean isCurrent() {
        return thread == Thread.currentThread();
    }

    final boolean isRetired() {
        return retired;
    }

    /** Ends the thread after its present round, which is interrupted. */
    final void retire() {
        retired = true;
        interrupt();
    }

    /**
     * Waits for the thread to end, unless it is the caller's. An interrupt of the caller does not cut the wait short;
     * its flag is restored.
     *
     * @return whether it has ended, or is the caller's thread
     */
    final boolean join(Duration limit) {
        return isCurrent() || Threads.join(thread, limit);
    }
}
