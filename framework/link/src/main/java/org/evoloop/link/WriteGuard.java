package org.evoloop.link;

import static java.util.concurrent.TimeUnit.MILLISECONDS;

import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;

/**
 * Makes sure that every write returns. On Linux, a write to a port whose peer does not read never returns by itself; so
 * when its time is up, it is cut short, repeatedly until it returns.
 *
 * <p>Threading: runs on its own daemon thread, which sleeps while nothing is written. It is not woken for a write that
 * soon follows another one, and takes no lock that a write could wait for. One write at a time.
 */
final class WriteGuard {
    private static final long CUT_INTERVAL_NANOS = MILLISECONDS.toNanos(10);

    /** No write is in progress. Deadlines are odd, so that they differ from this and from {@link #LATE}. */
    private static final long IDLE = 0;

    /** The time of the write in progress is up. */
    private static final long LATE = 2;

    private final long shortestLimitNanos;
    private final Runnable cutShort;
    private final Thread thread;

    /** The deadline of the write in progress, by {@link System#nanoTime()}, or one of the two constants above. */
    private final AtomicLong due = new AtomicLong(IDLE);

    /** The watching thread; null before it has started, when no wake-up is needed. */
    private volatile @Nullable Thread watcher;

    private volatile boolean ended;
    private volatile boolean asleep;
    private volatile boolean usedLately;

    /**
     * Watches after {@link #start}.
     *
     * @param shortestLimitNanos the shortest time limit of any write
     * @param cutShort makes the port return from reads and writes at once, and discard its buffers; called every 10 ms
     *     while a write is late, on the guard's thread
     */
    WriteGuard(long shortestLimitNanos, Runnable cutShort, String threadName) {
        this.shortestLimitNanos = shortestLimitNanos;
        this.cutShort = cutShort;
        this.thread = new Thread(this::watch, threadName);
        thread.setDaemon(true);
    }

    void start() {
        thread.start();
    }

    /** Begins a write that must end before {@code deadlineNanoTime}, by {@link System#nanoTime()}. */
    void begin(long deadlineNanoTime) {
        usedLately = true;
        due.set(deadlineNanoTime | 1);
        if (asleep) {
            LockSupport.unpark(watcher);
        }
    }

    /** Whether the time of the write in progress is up. */
    boolean isLate() {
        return due.get() == LATE;
    }

    /** Ends a write that has returned; returns false if its time was already up. */
    boolean done() {
        return due.getAndSet(IDLE) != LATE;
    }

    /** Cuts the deadline of the write in progress, if there is one, to a moment. */
    void hurry() {
        long soon = (System.nanoTime() + CUT_INTERVAL_NANOS) | 1;
        due.updateAndGet(current -> current == IDLE || current == LATE ? current : soon);
        LockSupport.unpark(watcher);
    }

    /** Ends the thread. If this returns true, it does not touch the port any more. */
    boolean end(long limitNanos) {
        ended = true;
        LockSupport.unpark(watcher);
        return BoundedWait.forEnd(thread, limitNanos);
    }

    /** The thread's loop, until {@link #end}. */
    void watch() {
        watcher = Thread.currentThread();
        while (!ended) {
            long deadline = due.get();
            if (deadline != IDLE) {
                watchWrite(deadline);
            } else if (usedLately) {
                // A write that begins in the meantime is not late before this wait is over.
                usedLately = false;
                LockSupport.parkNanos(this, shortestLimitNanos);
            } else {
                sleep();
            }
        }
    }

    private void sleep() {
        asleep = true;
        // Checks again: a write that began just before did not see the thread asleep.
        if (due.get() == IDLE && !ended) {
            LockSupport.park(this);
        }
        asleep = false;
    }

    private void watchWrite(long deadline) {
        long leftNanos = deadline - System.nanoTime();
        if (deadline != LATE && leftNanos > 0) {
            LockSupport.parkNanos(this, leftNanos);
        } else if (deadline == LATE || due.compareAndSet(deadline, LATE)) {
            cutShort.run();
            LockSupport.parkNanos(this, CUT_INTERVAL_NANOS);
        }
    }
}
