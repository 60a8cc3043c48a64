package org.evoloop.roomba.link;

import static java.util.concurrent.TimeUnit.MILLISECONDS;
import static java.util.concurrent.TimeUnit.NANOSECONDS;

import com.fazecast.jSerialComm.SerialPort;
import java.util.Arrays;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import org.evoloop.roomba.link.LinkException.Fault;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One opened serial port from start to end. The reader thread alone gives the port back, after the last write
 * has ended: jSerialComm must not be inside a port that closes, or it touches memory and file descriptors of others.
 *
 * <p>Whatever ends the session, the first cause wins, the reader is woken and does the rest.
 */
final class SerialSession {
    private static final Logger LOG = LoggerFactory.getLogger(SerialSession.class);

    private static final int BUFFER_BYTES = 4_096;

    private static final long LONGEST_SILENCE_WAIT_NANOS = MILLISECONDS.toNanos(2_000);
    private static final long WRITER_END_LIMIT_NANOS = MILLISECONDS.toNanos(1_000);
    private static final long READER_END_LIMIT_NANOS = MILLISECONDS.toNanos(2_000);

    private final SerialPort port;
    private final SerialSettings settings;
    private final Link.Receiver receiver;
    private final SerialWriter writer;
    private final Thread reader;
    private final AtomicBoolean closing = new AtomicBoolean();
    private final AtomicReference<@Nullable LinkException> end = new AtomicReference<>();
    private final CountDownLatch released = new CountDownLatch(1);
    private final Object wakeLineLock = new Object();

    /** Takes over a port that has just been opened. */
    SerialSession(SerialPort port, SerialSettings settings, Link.Receiver receiver) {
        this.port = port;
        this.settings = settings;
        this.receiver = receiver;
        String name = "evoloop-serial-" + settings.shortName();
        this.writer = new SerialWriter(port, settings, () -> end(SerialFaults.notReading(settings)), name + "-guard");
        this.reader = daemon(name, this::receive);
    }

    static Thread daemon(String name, Runnable task) {
        Thread thread = new Thread(task, name);
        thread.setDaemon(true);
        return thread;
    }

    void start() {
        writer.start();
        reader.start();
    }

    void send(byte[] bytes) {
        switch (writer.write(bytes)) {
            case WRITTEN -> {}
            case REFUSED -> throw closing.get() ? SerialFaults.closed(settings) : end(SerialFaults.hungUp(settings));
            case LATE -> throw end(SerialFaults.notReading(settings));
        }
    }

    boolean setWakeLine(boolean low) {
        synchronized (wakeLineLock) {
            return end.get() == null && settings.wakeSignal().drive(port, low);
        }
    }

    /** Ends the session; returns its first cause, which is the given one unless it has ended before. */
    private LinkException end(LinkException cause) {
        LinkException first = end.compareAndExchange(null, cause);
        if (first != null) {
            return first;
        }
        // A new mode wakes who waits to read or to write inside the old one; the port stays open under them.
        port.setComPortTimeouts(SerialPort.TIMEOUT_NONBLOCKING, 0, 0);
        return cause;
    }

    private void receive() {
        byte[] buffer = new byte[BUFFER_BYTES];
        while (end.get() == null) {
            int length = port.readBytes(buffer, buffer.length);
            if (length > 0) {
                tell("received", () -> receiver.received(buffer, length));
            } else {
                // A blocking read that brings nothing has been hung up; reading on would spin.
                end(SerialFaults.hungUp(settings));
            }
        }
        release();
        released.countDown();
        LinkException cause = end.get();
        if (cause != null && cause.fault() != Fault.CLOSED) {
            tell("lost", () -> receiver.lost(cause));
        }
    }

    private void tell(String what, Runnable call) {
        try {
            call.run();
        } catch (Throwable failure) {
            // Not even an Error may end the reader here, or nobody would give the port back.
            LOG.error("{}: the receiver failed in '{}'", settings, what, failure);
        }
    }

    private void release() {
        if (!writer.end(WRITER_END_LIMIT_NANOS)) {
            LOG.error("{}: a write is stuck, so the port stays open until the program ends", settings);
            return;
        }
        synchronized (wakeLineLock) {
            settings.wakeSignal().drive(port, false);
            port.closePort();
        }
    }

    void close() {
        if (closing.compareAndSet(false, true)) {
            awaitSilence();
            end(SerialFaults.closed(settings));
        }
        if (Thread.currentThread() != reader && !BoundedWait.forEnd(reader, READER_END_LIMIT_NANOS)) {
            LOG.error("thread {} is stuck at {}", reader.getName(), Arrays.toString(reader.getStackTrace()));
        }
    }

    /** Waits for writes under way, and until what they wrote has left; a session that ends needs no more waiting. */
    private void awaitSilence() {
        writer.finish();
        long wait = writer.closableNanoTime() - System.nanoTime();
        if (wait > 0) {
            BoundedWait.uninterruptibly(
                    Math.min(wait, LONGEST_SILENCE_WAIT_NANOS), nanos -> released.await(nanos, NANOSECONDS));
        }
    }
}
