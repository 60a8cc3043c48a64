package org.evoloop.link;

import static java.util.concurrent.TimeUnit.MILLISECONDS;
import static java.util.concurrent.TimeUnit.NANOSECONDS;

import java.util.Arrays;
import java.util.concurrent.locks.ReentrantLock;

/**
 * Writes on the caller's thread, since waking another thread takes longer than everything else a command needs. A
 * {@link WriteGuard} ends a write that is late.
 *
 * <p>Threading: thread-safe; writes leave in the order of the calls.
 */
final class SerialWriter {
    /** The most that may still reach, late, a peer that has not read for a long time. */
    private static final int CHUNK_BYTES = 1_024;

    /** An upper bound for the bytes on the way; the buffers of drivers and adapters are of this order. */
    private static final int BUFFERED_BYTES = 4_096;

    /**
     * The silence required before the port is closed, since closing it discards its buffers. An adapter's full buffer
     * of 512 bytes needs 44 ms at 115200 baud; a simulator on a busy computer sometimes needs more.
     */
    private static final long SILENCE_NANOS = 100_000_000;

    /** How often the driver is asked whether it has bytes left. */
    private static final long LOOK_NANOS = 5_000_000;

    private final Port port;
    private final SerialSettings settings;
    private final WriteGuard guard;
    private final ReentrantLock turn = new ReentrantLock(true);
    private volatile boolean ending;

    /** When the last byte will have been sent, by {@link System#nanoTime()}; guarded by {@link #turn}. */
    private long lineIdleNanoTime = System.nanoTime();

    private volatile long closableNanoTime = System.nanoTime();

    /** The driver of the port. */
    interface Port {
        /** Returns how many of the bytes it has accepted. */
        int write(byte[] bytes);

        /** How many accepted bytes have not left yet, as far as the driver knows; 0 or less if it does not know. */
        int waiting();
    }

    enum Outcome {
        WRITTEN,
        REFUSED,
        LATE
    }

    /**
     * Writes after {@link #start}.
     *
     * @param cutShort makes the port return from a write that is late, see {@link WriteGuard}
     */
    SerialWriter(Port port, SerialSettings settings, Runnable cutShort, String guardName) {
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

    /** Makes later writes fail after the earlier ones have finished or run out of time. */
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
            if (ending || guard.isLate() || port.write(chunk) != chunk.length) {
                return Outcome.REFUSED;
            }
            long now = System.nanoTime();
            long sent = Math.max(now, lineIdleNanoTime) + settings.lineNanos(chunk.length);
            lineIdleNanoTime = Math.min(sent, now + settings.lineNanos(BUFFERED_BYTES));
            closableNanoTime = lineIdleNanoTime + SILENCE_NANOS;
        }
        return Outcome.WRITTEN;
    }

    /**
     * Waits until the driver has no bytes left and the line has been silent, so that closing the port loses none. How
     * long bytes take is only estimated, so the driver is asked, too.
     *
     * @param limitNanos for drivers whose bytes never leave
     * @param ended a wait that is over when the link has ended, after which no bytes can leave
     */
    void awaitSilence(long limitNanos, BoundedWait.Attempt ended) {
        long deadline = System.nanoTime() + limitNanos;
        boolean over = false;
        for (long now = System.nanoTime(); !over && now < deadline; now = System.nanoTime()) {
            boolean waiting = port.waiting() > 0;
            if (waiting) {
                closableNanoTime = Math.max(closableNanoTime, now + SILENCE_NANOS);
            } else if (now >= closableNanoTime) {
                return;
            }
            long pause = waiting ? LOOK_NANOS : Math.min(closableNanoTime, deadline) - now;
            over = BoundedWait.uninterruptibly(pause, ended);
        }
    }

    /**
     * Makes waiting and later writes fail, and ends the one in progress; returns false if that did not return in time.
     */
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
