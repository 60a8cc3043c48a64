package org.evoloop.roomba.link;

import static java.util.concurrent.TimeUnit.MILLISECONDS;
import static java.util.concurrent.TimeUnit.NANOSECONDS;

import com.fazecast.jSerialComm.SerialPort;

/**
 * Sees to it that a write comes to its end, which a write to a port whose peer does not read never does by itself on Linux:
 * when its time is over the session is ended, and what stands in the port's buffers is dropped.
 *
 * <p>Threading: watches on a daemon thread of its own, which sleeps while nothing is written. It is not woken for a write
 * that soon follows another one: a write must not wait for that. One write at a time.
 */
final class WriteGuard {
    private static final long FLUSH_INTERVAL_NANOS = MILLISECONDS.toNanos(10);

    private final SerialPort port;
    private final long shortestLimitNanos;
    private final Runnable endSession;
    private final Thread thread;
    private boolean ended;
    private boolean asleep;
    private boolean usedLately;
    private boolean writing;
    private boolean late;
    private long deadlineNanoTime;

    /**
     * Watches from {@link #start} on.
     *
     * @param shortestLimitNanos no write has less time than this
     * @param endSession sets the port to return from reads and writes at once; called when a write is late, by the guard's
     *     thread
     */
    WriteGuard(SerialPort port, long shortestLimitNanos, Runnable endSession, String threadName) {
        this.port = port;
        this.shortestLimitNanos = shortestLimitNanos;
        this.endSession = endSession;
        this.thread = SerialSession.daemon(threadName, this::watch);
    }

    void start() {
        thread.start();
    }

    /** A write begins, which has to end before {@code deadlineNanoTime}, by {@link System#nanoTime()}. */
    synchronized void begin(long deadlineNanoTime) {
        this.deadlineNanoTime = deadlineNanoTime;
        writing = true;
        late = false;
        usedLately = true;
        if (asleep) {
            notifyAll();
        }
    }

    /** Whether the time of the last write that began was over before it was done. */
    synchronized boolean isLate() {
        return late;
    }

    /** The write has returned. */
    synchronized void done() {
        writing = false;
    }

    /** The write under way, if there is one, has only a moment left. */
    synchronized void hurry() {
        deadlineNanoTime = System.nanoTime() + FLUSH_INTERVAL_NANOS;
        notifyAll();
    }

    /** Ends the thread; it touches the port no more when this returns true. */
    boolean end(long limitNanos) {
        synchronized (this) {
            ended = true;
            notifyAll();
        }
        return BoundedWait.forEnd(thread, limitNanos);
    }

    private synchronized void watch() {
        try {
            while (!ended) {
                if (writing) {
                    watchWrite();
                } else if (usedLately) {
                    // A write that begins meanwhile is not due before this is over.
                    usedLately = false;
                    NANOSECONDS.timedWait(this, shortestLimitNanos);
                } else {
                    asleep = true;
                    wait();
                    asleep = false;
                }
            }
        } catch (InterruptedException nobodyDoes) {
            Thread.currentThread().interrupt();
        }
    }

    private void watchWrite() throws InterruptedException {
        long leftNanos = deadlineNanoTime - System.nanoTime();
        if (leftNanos > 0) {
            NANOSECONDS.timedWait(this, leftNanos);
        } else {
            late = true;
            endSession.run();
            port.flushIOBuffers();
            NANOSECONDS.timedWait(this, FLUSH_INTERVAL_NANOS);
        }
    }
}
