package org.evoloop.roomba.session.connection;

import java.time.Duration;
import java.util.Arrays;
import java.util.function.IntFunction;
import org.evoloop.link.BoundedWait;
import org.evoloop.link.Link;
import org.evoloop.link.LinkException;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.Opcode;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The current link, which is replaced each time the cable is plugged in again, and the thread that reads it.
 *
 * <p>Threading: any thread may send and close; only one thread at a time replaces and compares links.
 */
final class Plug {
    private static final Logger LOG = LoggerFactory.getLogger(RobotConnection.class);

    /** A song that claims to have 255 notes. */
    private static final int LONGEST_COMMAND = 3 + 2 * 255;

    private static final int BITS_PER_BYTE = 10;
    private static final String READER = "roomba-reader";
    private static final long READER_END_LIMIT_NANOS = 2_000_000_000;

    private final IntFunction<Link> cable;
    private volatile @Nullable Link link;
    private volatile @Nullable Thread reader;
    private long pluggings;

    /** @param cable opens a new link at a baud rate */
    Plug(IntFunction<Link> cable) {
        this.cable = cable;
    }

    /** The number of the next link; callbacks of the previous one are ignored from now on. */
    long next() {
        return ++pluggings;
    }

    /** The number of the current link. */
    long current() {
        return pluggings;
    }

    /**
     * Opens another link.
     *
     * @throws LinkException if that cannot be done
     */
    Link open(int baud) {
        Link fresh = cable.apply(baud);
        link = fresh;
        return fresh;
    }

    /** Reads the current link on a separate thread, which must end with the link. */
    void startReading(Runnable reading) {
        Thread started = new Thread(reading, READER);
        started.setDaemon(true);
        reader = started;
        started.start();
    }

    /** The current link; null before the first. */
    @Nullable
    Link link() {
        return link;
    }

    /** Closes the current link; its later callbacks are ignored. */
    void pull() {
        next();
        close();
    }

    /** Closes the current link, and waits for the reading thread to end. */
    void close() {
        Link current = link;
        if (current != null) {
            current.close();
        }
        Thread reading = reader;
        if (reading != null
                && reading != Thread.currentThread()
                && !BoundedWait.forEnd(reading, READER_END_LIMIT_NANOS)) {
            LOG.error("thread {} is stuck at {}", READER, Arrays.toString(reading.getStackTrace()));
        }
    }

    /**
     * Sends bytes.
     *
     * @throws LinkException if the robot cannot be reached
     */
    void send(byte[] bytes) {
        Link current = link;
        if (current == null) {
            throw new LinkException(LinkException.Fault.CLOSED, description());
        }
        current.send(bytes);
    }

    /** Sends a command if possible; else does nothing. */
    void trySend(Command command) {
        trySend(command.bytes());
    }

    private void trySend(byte[] bytes) {
        try {
            send(bytes);
        } catch (LinkException gone) {
            LOG.debug("{}", gone.getMessage());
        }
    }

    /**
     * A robot that has received only a part of a command waits for the rest forever (specification, "Roomba Open
     * Interface Commands"). Repeated Start commands complete any command: as data they are invalid for a change of the
     * baud rate, and as commands they do no harm to a robot that is not under control.
     */
    void completeWhateverIsPending() {
        byte[] starts = new byte[LONGEST_COMMAND];
        Arrays.fill(starts, (byte) Opcode.START.code());
        trySend(starts);
    }

    /** The time on the line of the bytes sent by {@link #completeWhateverIsPending()}. */
    static Duration completionTime(int baud) {
        return Duration.ofNanos(LONGEST_COMMAND * BITS_PER_BYTE * 1_000_000_000L / baud);
    }

    /** Sets the wake line low or high; returns whether the link has one. */
    boolean setWakeLine(boolean low) {
        Link current = link;
        return current != null && current.wakeLine().setLow(low);
    }

    String description() {
        Link current = link;
        return current == null ? "no link" : current.description();
    }
}
