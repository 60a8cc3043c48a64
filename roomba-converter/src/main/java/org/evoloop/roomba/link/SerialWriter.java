package org.evoloop.roomba.link;

import static java.util.concurrent.TimeUnit.NANOSECONDS;

import com.fazecast.jSerialComm.SerialPort;
import java.util.Arrays;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeoutException;

/**
 * Writes on a thread of its own, because a write to a port whose peer does not read never returns on Linux.
 *
 * <p>Threading: thread-safe; writes leave in the order of the calls.
 */
final class SerialWriter {
    /** Small enough that a flush of the port lets a stuck write end. */
    private static final int CHUNK_BYTES = 1_024;

    /** What the line is thought to hold at most; a driver's and an adapter's buffers are of this order. */
    private static final int BUFFERED_BYTES = 4_096;

    private final SerialPort port;
    private final SerialSettings settings;
    private final ExecutorService thread;
    private volatile boolean ending;
    private volatile long silentNanoTime = System.nanoTime();

    enum Outcome {
        WRITTEN,
        REFUSED,
        LATE
    }

    SerialWriter(SerialPort port, SerialSettings settings, String threadName) {
        this.port = port;
        this.settings = settings;
        this.thread = Executors.newSingleThreadExecutor(task -> SerialSession.daemon(threadName, task));
    }

    Outcome write(byte[] bytes) {
        CompletableFuture<Outcome> outcome = new CompletableFuture<>();
        try {
            thread.execute(() -> outcome.complete(writeAll(bytes)));
        } catch (RejectedExecutionException ended) {
            return Outcome.REFUSED;
        }
        long limitNanos = settings.sendLimitMillis() * 1_000_000L + settings.lineNanos(bytes.length);
        BoundedWait.uninterruptibly(limitNanos, nanos -> completes(outcome, nanos));
        return outcome.getNow(Outcome.LATE);
    }

    private static boolean completes(CompletableFuture<?> future, long nanos) throws InterruptedException {
        try {
            future.get(nanos, NANOSECONDS);
            return true;
        } catch (TimeoutException | ExecutionException notNow) {
            return false;
        }
    }

    private Outcome writeAll(byte[] bytes) {
        for (int start = 0; start < bytes.length; start += CHUNK_BYTES) {
            byte[] chunk = Arrays.copyOfRange(bytes, start, Math.min(start + CHUNK_BYTES, bytes.length));
            if (ending || port.writeBytes(chunk, chunk.length) != chunk.length) {
                return Outcome.REFUSED;
            }
            long now = System.nanoTime();
            long silent = Math.max(now, silentNanoTime) + settings.lineNanos(chunk.length);
            silentNanoTime = Math.min(silent, now + settings.lineNanos(BUFFERED_BYTES));
        }
        return Outcome.WRITTEN;
    }

    /** When the last byte has left, by {@link System#nanoTime()} and the line's rate; past if nothing was written. */
    long silentNanoTime() {
        return silentNanoTime;
    }

    /** Lets waiting and later writes fail, and waits for the thread's end; false if it did not come in time. */
    boolean end(long limitNanos) {
        ending = true;
        thread.shutdown();
        return BoundedWait.uninterruptibly(limitNanos, nanos -> thread.awaitTermination(nanos, NANOSECONDS));
    }
}
