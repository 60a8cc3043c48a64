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
import java.util.function.Supplier;

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

    /**
     * Closing a port throws away what still stands in its buffers. So long must the line have been silent before: an
     * adapter's full buffer of 512 bytes needs 44 ms at 115200 baud, a simulator on a busy computer sometimes more.
     */
    private static final long SILENCE_NANOS = 100_000_000;

    private final SerialPort port;
    private final SerialSettings settings;
    private final ExecutorService thread;
    private volatile boolean ending;

    /** When the last byte will be on the line, by {@link System#nanoTime()}. The writing thread's own. */
    private long lineIdleNanoTime = System.nanoTime();

    private volatile long closableNanoTime = System.nanoTime();

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
        return inTurn(() -> writeAll(bytes), settings.lineNanos(bytes.length));
    }

    /** Lets later writes fail once the earlier ones are through, or have had their time. */
    Outcome finish() {
        return inTurn(
                () -> {
                    ending = true;
                    return Outcome.WRITTEN;
                },
                0);
    }

    private Outcome inTurn(Supplier<Outcome> task, long lineNanos) {
        CompletableFuture<Outcome> outcome = new CompletableFuture<>();
        try {
            thread.execute(() -> outcome.complete(task.get()));
        } catch (RejectedExecutionException ended) {
            return Outcome.REFUSED;
        }
        long limitNanos = settings.sendLimitMillis() * 1_000_000L + lineNanos;
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

    /** Lets waiting and later writes fail, and waits for the thread's end; false if it did not come in time. */
    boolean end(long limitNanos) {
        ending = true;
        thread.shutdown();
        return BoundedWait.uninterruptibly(limitNanos, nanos -> thread.awaitTermination(nanos, NANOSECONDS));
    }
}
