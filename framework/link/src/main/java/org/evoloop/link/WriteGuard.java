package org.evoloop.link;

import static java.util.concurrent.TimeUnit.MILLISECONDS;

import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;

/**
 * Sees to it that a write comes to its end, which a write to a port whose peer does not read never does by itself on
 * Linux: when its time is over it is cut short, again and again until it returns.
 *
 * <p>Threading: watches on a daemon thread of its own, which sleeps while nothing is written. It is not woken for a
 * write that soon follows another one, and takes no lock that a write could wait for. One write at a time.
 */
final class WriteGuard {
    private static final long CUT_INTERVAL_NANOS = MILLISECONDS.toNanos(10);

    /** Nobody writes. Deadlines are odd, so that they are neither this nor {@link #LATE}. */
    private static final long IDLE = 0;

    /** The write under way has had its time. */
    private static final long LATE = 2;

    private final long shortestLimitNanos;
    private final Runnable cutShort;
    private final Thread thread;

    /** When the write under way has to end, by {@link System#nanoTime()}, or one of the two words above. */
    private final AtomicLong due = new AtomicLong(IDLE);

    /** Who watches; null before that has begun, when there is nobody to wake. */
    private volatile @Nullable Thread watcher;

    private volatile boolean ended;
    private volatile boolean asleep;
    private volatile boolean usedLately;

    /**
     * Watches from {@link #start} on.
     *
     * @param shortestLimitNanos no write has less time than this
     * @param cutShort has the port return from reads and writes at once, and drop what stands in its buffers; called
     *     every 10 ms while a write is late, by the guard's thread
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

    /** A write begins, which has to end before {@code deadlineNanoTime}, by {@link System#nanoTime()}. */
    void begin(long deadlineNanoTime) {
        usedLately = true;
        due.set(deadlineNanoTime | 1);
        if (asleep) {
            LockSupport.unpark(watcher);
        }
    }

    /** Whether the time of the write under way is over. */
    boolean isLate() {
        return due.get() == LATE;
    }

    /** The write has returned; false if its time was over before that. */
    boolean done() {
        return due.getAndSet(IDLE) != LATE;
    }

    /** The write under way, if there is one, has only a moment left. */
    void hurry() {
        long soon = (System.nanoTime() + CUT_INTERVAL_NANOS) | 1;
        due.updateAndGet(current -> current == IDLE || current == LATE ? current : soon);
        LockSupport.unpark(watcher);
    }

    /** Ends the thread; it touches the port no more when this returns true. */
    boolean end(long limitNanos) {
        ended = true;
        LockSupport.unpark(watcher);
        return BoundedWait.forEnd(thread, limitNanos);
    }

    /** What the thread does until the {@link #end}. */
    void watch() {
        watcher = Thread.currentThread();
        while (!ended) {
            long deadline = due.get();
            if (deadline != IDLE) {
                watchWrite(deadline);
            } else if (usedLately) {
                // A write that begins meanwhile is not due before this is over.
                usedLately = false;
                LockSupport.parkNanos(this, shortestLimitNanos);
            } else {
                sleep();
            }
        }
    }

    private void sleep() {
        asleep = true;
        // Looks once more: a write that began before saw nobody asleep.
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
