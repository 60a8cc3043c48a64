package org.evoloop.link;

import static java.util.concurrent.TimeUnit.MILLISECONDS;
import static java.util.concurrent.TimeUnit.NANOSECONDS;

import java.util.Arrays;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.ToIntFunction;

/**
 * Writes on the caller's thread, since waking another one takes longer than all that a command needs before. A
 * {@link WriteGuard} ends a write whose time is over.
 *
 * <p>Threading: thread-safe; writes leave in the order of the calls.
 */
final class SerialWriter {
    /** So much of what a peer has not read for long may still come to it late. */
    private static final int CHUNK_BYTES = 1_024;

    /** What the line is thought to hold at most; a driver's and an adapter's buffers are of this order. */
    private static final int BUFFERED_BYTES = 4_096;

    /**
     * Closing a port throws away what still stands in its buffers. So long must the line have been silent before: an
     * adapter's full buffer of 512 bytes needs 44 ms at 115200 baud, a simulator on a busy computer sometimes more.
     */
    private static final long SILENCE_NANOS = 100_000_000;

    private final ToIntFunction<byte[]> port;
    private final SerialSettings settings;
    private final WriteGuard guard;
    private final ReentrantLock turn = new ReentrantLock(true);
    private volatile boolean ending;

    /** When the last byte will be on the line, by {@link System#nanoTime()}; whose turn it is may look. */
    private long lineIdleNanoTime = System.nanoTime();

    private volatile long closableNanoTime = System.nanoTime();

    enum Outcome {
        WRITTEN,
        REFUSED,
        LATE
    }

    /**
     * Writes from {@link #start} on.
     *
     * @param port writes bytes and returns how many it has taken
     * @param cutShort has the port return from a write that is late, see {@link WriteGuard}
     */
    SerialWriter(ToIntFunction<byte[]> port, SerialSettings settings, Runnable cutShort, String guardName) {
        this.port = port;
        this.settings = settings;
        this.guard = new WriteGuard(limitNanos(0), cutShort, guardName);
    }

    void start() {
        guard.start();
    }

    private long limitNanos(int bytes) {
        return MILLISECONDS.toNanos(settings.sendLimitMillis()) + settings.lineNanos(bytes);
    }

    Outcome write(byte[] bytes) {
        long limitNanos = limitNanos(bytes.length);
        long deadline = System.nanoTime() + limitNanos;
        boolean free = !turn.hasQueuedThreads() && turn.tryLock();
        if (!free && !takeTurn(limitNanos)) {
            return Outcome.LATE;
        }
        Outcome outcome = Outcome.REFUSED;
        guard.begin(deadline);
        try {
            outcome = writeAll(bytes);
        } finally {
            if (!guard.done()) {
                outcome = Outcome.LATE;
            }
            turn.unlock();
        }
        return outcome;
    }

    private boolean takeTurn(long limitNanos) {
        return BoundedWait.uninterruptibly(limitNanos, nanos -> turn.tryLock(nanos, NANOSECONDS));
    }

    /** Lets later writes fail once the earlier ones are through, or have had their time. */
    void finish() {
        boolean mine = takeTurn(limitNanos(0));
        ending = true;
        if (mine) {
            turn.unlock();
        }
    }

    private Outcome writeAll(byte[] bytes) {
        for (int start = 0; start < bytes.length; start += CHUNK_BYTES) {
            int end = Math.min(start + CHUNK_BYTES, bytes.length);
            byte[] chunk = end == bytes.length && start == 0 ? bytes : Arrays.copyOfRange(bytes, start, end);
            if (ending || guard.isLate() || port.applyAsInt(chunk) != chunk.length) {
                return Outcome.REFUSED;
            }
            long now = System.nanoTime();
            long sent = Math.max(now, lineIdleNanoTime) + settings.lineNanos(chunk.length);
            lineIdleNanoTime = Math.min(sent, now + settings.lineNanos(BUFFERED_BYTES));
            closableNanoTime = lineIdleNanoTime + SILENCE_NANOS;
        }
        return Outcome.WRITTEN;
    }

    /** From when on the port can be closed without losing what was written, by {@link System#nanoTime()}. */
    long closableNanoTime() {
        return closableNanoTime;
    }

    /** Lets waiting and later writes fail, and ends the one under way; false if that did not return in time. */
    boolean end(long limitNanos) {
        ending = true;
        guard.hurry();
        boolean idle = takeTurn(limitNanos);
        if (idle) {
            turn.unlock();
        }
        return guard.end(limitNanos) && idle;
    }
}
