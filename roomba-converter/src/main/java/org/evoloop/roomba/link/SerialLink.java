package org.evoloop.roomba.link;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The cable as a serial port: a USB adapter, the Raspberry Pi's own UART, or the simulator's pseudo-terminal.
 *
 * <p>The port is locked against other programs. What was received before {@link #open} is dropped. {@link #close}
 * waits until the line has been silent for 100 ms, so that the last command arrives.
 *
 * <p>Threading: receives on a daemon thread named {@code evoloop-serial-<port>} that waits inside the operating system;
 * another, {@code evoloop-serial-<port>-guard}, watches over writes, which run on the caller's. Both end with the link. A
 * peer that takes no bytes holds {@link #send} for {@link SerialSettings#sendLimitMillis()} at most; then the link is lost,
 * and bytes that have not reached the peer's end are dropped so that they do not come to the robot late.
 */
public final class SerialLink implements Link {
    private final SerialSettings settings;
    private volatile @Nullable SerialSession session;
    private boolean closed;

    public SerialLink(SerialSettings settings) {
        this.settings = settings;
    }

    /**
     * Has the serial library loaded, which takes longer than opening a link. A program that has other things to do before
     * calls this on another thread; whoever needs the library meanwhile waits for it.
     *
     * @throws LinkException if it cannot be loaded
     */
    public static void prepare() {
        SerialPorts.load();
    }

    /** The paths of the serial ports this computer has, in alphabetical order. Pseudo-terminals are not among them. */
    public static List<String> available() {
        return SerialPorts.available();
    }

    /**
     * Has a thread run when the program ends, while links still work. A plain shutdown hook is too late: jSerialComm
     * has one that closes all ports, and the hooks of a program run in no order.
     */
    public static void addShutdownHook(Thread hook) {
        SerialPorts.addShutdownHook(hook);
    }

    @Override
    public synchronized void open(Receiver receiver) {
        if (closed || session != null) {
            throw new IllegalStateException(settings + " has been opened or closed before; make a new link");
        }
        SerialSession opened = new SerialSession(SerialPorts.open(settings), settings, receiver);
        session = opened;
        opened.start();
    }

    @Override
    public void send(byte[] bytes) {
        SerialSession current = session;
        if (current == null) {
            throw SerialFaults.closed(settings);
        }
        current.send(bytes);
    }

    @Override
    public WakeLine wakeLine() {
        return low -> {
            SerialSession current = session;
            return current != null && current.setWakeLine(low);
        };
    }

    @Override
    public String description() {
        return settings.toString();
    }

    @Override
    public void close() {
        SerialSession current = markClosed();
        if (current != null) {
            current.close();
        }
    }

    private synchronized @Nullable SerialSession markClosed() {
        closed = true;
        return session;
    }
}
