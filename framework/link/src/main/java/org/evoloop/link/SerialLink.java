package org.evoloop.link;

import static java.util.concurrent.TimeUnit.MILLISECONDS;
import static java.util.concurrent.TimeUnit.NANOSECONDS;

import com.fazecast.jSerialComm.SerialPort;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.ReentrantLock;
import org.evoloop.link.LinkException.Fault;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The cable as a serial port: a USB adapter, the Raspberry Pi's own UART, or the simulator's pseudo-terminal.
 *
 * <p>The port is locked against other programs. Bytes received before it was opened are dropped. {@link #close} waits
 * until the driver has no bytes left and the line has been silent for 100 ms, so that the last command arrives, but no
 * longer than 2 s.
 *
 * <p>Threading: {@link #receive} waits inside the operating system. A daemon thread named {@code
 * evoloop-serial-<port>-guard}, which ends with the link, monitors writes. A peer that accepts no bytes blocks {@link
 * #send} for {@link SerialSettings#sendLimitMillis()} at most; then the link is lost, and bytes that the peer has not
 * received are dropped so that they do not reach the device late.
 *
 * @since 0.1
 */
public final class SerialLink implements Link {
    private static final Logger LOG = LoggerFactory.getLogger(SerialLink.class);

    private static final long LONGEST_SILENCE_WAIT_NANOS = MILLISECONDS.toNanos(2_000);
    private static final long WRITER_END_LIMIT_NANOS = MILLISECONDS.toNanos(1_000);
    private static final long READER_END_LIMIT_NANOS = MILLISECONDS.toNanos(2_000);

    private final SerialPort port;
    private final SerialSettings settings;
    private final SerialWriter writer;

    /** Held during a read, and while the port is released. */
    private final ReentrantLock reading = new ReentrantLock();

    private final AtomicBoolean closing = new AtomicBoolean();
    private final AtomicReference<@Nullable LinkException> end = new AtomicReference<>();
    private final CountDownLatch released = new CountDownLatch(1);

    /** Held during a call on the port that is neither a read nor a write, and while the port is closed. */
    private final Object portLock = new Object();

    private SerialLink(SerialPort port, SerialSettings settings) {
        this.port = port;
        this.settings = settings;
        this.writer = new SerialWriter(
                new SerialWriter.Port() {
                    @Override
                    public int write(byte[] bytes) {
                        return port.writeBytes(bytes, bytes.length);
                    }

                    @Override
                    public int waiting() {
                        synchronized (portLock) {
                            return end.get() == null ? port.bytesAwaitingWrite() : 0;
                        }
                    }
                },
                settings,
                () -> {
                    end(SerialFaults.notReading(settings));
                    port.flushIOBuffers();
                },
                "evoloop-serial-" + settings.shortName() + "-guard");
    }

    /**
     * Opens a port.
     *
     * @throws LinkException if it cannot be used
     */
    public static SerialLink open(SerialSettings settings) {
        SerialLink opened = new SerialLink(SerialPorts.open(settings), settings);
        opened.writer.start();
        return opened;
    }

    /**
     * Loads the serial library, which takes longer than opening a link. A program with other work to do first can call
     * this on another thread; code that needs the library in the meantime waits for it.
     *
     * @throws LinkException if it cannot be loaded
     */
    public static void prepare() {
        SerialPorts.load();
    }

    /** The paths of this computer's serial ports, in alphabetical order, without pseudo-terminals. */
    public static List<String> available() {
        return SerialPorts.available();
    }

    /**
     * Registers a thread that runs when the program ends, while links still work. A plain shutdown hook may be too
     * late: jSerialComm has one that closes all ports, and a program's hooks run in no particular order.
     */
    public static void addShutdownHook(Thread hook) {
        SerialPorts.addShutdownHook(hook);
    }

    @Override
    public int receive(byte[] buffer) {
        reading.lock();
        try {
            int length = end.get() == null ? port.readBytes(buffer, buffer.length) : ENDED;
            if (length > 0) {
                return length;
            }
            // A blocking read that returns nothing means a hang-up; reading on would spin.
            end(SerialFaults.hungUp(settings));
            release();
            return ENDED;
        } finally {
            reading.unlock();
        }
    }

    @Override
    public @Nullable LinkException loss() {
        LinkException cause = end.get();
        return cause == null || cause.fault() == Fault.CLOSED ? null : cause;
    }

    @Override
    public void send(byte[] bytes) {
        switch (writer.write(bytes)) {
            case WRITTEN -> {}
            case REFUSED -> throw closing.get() ? SerialFaults.closed(settings) : end(SerialFaults.hungUp(settings));
            case LATE -> throw end(SerialFaults.notReading(settings));
        }
    }

    @Override
    public WakeLine wakeLine() {
        return low -> {
            synchronized (portLock) {
                return end.get() == null && settings.wakeSignal().drive(port, low);
            }
        };
    }

    @Override
    public String description() {
        return settings.toString();
    }

    /** Ends the link. Returns the first cause, which is the given one unless the link has already ended. */
    private LinkException end(LinkException cause) {
        // The first cause stands: what a thread sees afterwards, such as a read that returns nothing, follows from it.
        LinkException first = end.compareAndExchange(null, cause);
        if (first != null) {
            return first;
        }
        // Changing the mode wakes threads that wait in a read or a write; the port stays open meanwhile.
        port.setComPortTimeouts(SerialPort.TIMEOUT_NONBLOCKING, 0, 0);
        return cause;
    }

    @Override
    public void close() {
        // Only the first caller ends the writer; the others wait below, since the port may only be closed when nobody
        // reads.
        if (closing.compareAndSet(false, true)) {
            writer.finish();
            writer.awaitSilence(LONGEST_SILENCE_WAIT_NANOS, nanos -> released.await(nanos, NANOSECONDS));
            end(SerialFaults.closed(settings));
        }
        if (!BoundedWait.uninterruptibly(READER_END_LIMIT_NANOS, nanos -> reading.tryLock(nanos, NANOSECONDS))) {
            LOG.error("{}: a read is stuck, so the port stays open until the program ends", settings);
            return;
        }
        try {
            release();
        } finally {
            reading.unlock();
        }
    }

    /**
     * Closes the port, after the last write has ended. If jSerialComm were inside a call on a port that is being
     * closed, it would touch memory and file descriptors that belong to others. The caller makes sure that nobody
     * reads.
     */
    private void release() {
        if (released.getCount() == 0) {
            return;
        }
        if (writer.end(WRITER_END_LIMIT_NANOS)) {
            synchronized (portLock) {
                settings.wakeSignal().drive(port, false);
                port.closePort();
            }
        } else {
            LOG.error("{}: a write is stuck, so the port stays open until the program ends", settings);
        }
        released.countDown();
    }
}
