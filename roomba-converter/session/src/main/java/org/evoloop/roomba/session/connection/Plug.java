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
 * One end of the cable: the link of the moment, which is replaced by another whenever it is plugged in anew, and the
 * thread that reads it.
 *
 * <p>Threading: any thread may send and close; links are replaced and told apart by one thread at a time.
 */
final class Plug {
    private static final Logger LOG = LoggerFactory.getLogger(Connection.class);

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

    /** What the next link will be known by; from now on what the last one tells is ignored. */
    long next() {
        return ++pluggings;
    }

    /** What the link of this moment is known by. */
    long current() {
        return pluggings;
    }

    /** Opens another link. @throws LinkException if that cannot be done */
    Link open(int baud) {
        Link fresh = cable.apply(baud);
        link = fresh;
        return fresh;
    }

    /** Reads the link of this moment on a thread of its own, which has to end with the link. */
    void startReading(Runnable reading) {
        Thread started = new Thread(reading, READER);
        started.setDaemon(true);
        reader = started;
        started.start();
    }

    /** The link of this moment; null before the first. */
    @Nullable
    Link link() {
        return link;
    }

    /** Closes the link of this moment; what it tells from now on is ignored. */
    void pull() {
        next();
        close();
    }

    /** Closes the link of this moment, and waits until nobody reads it any more. */
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

    /** Sends bytes. @throws LinkException if the robot cannot be reached */
    void send(byte[] bytes) {
        Link current = link;
        if (current == null) {
            throw new LinkException(LinkException.Fault.CLOSED, description());
        }
        current.send(bytes);
    }

    /** Sends a command if that can be done; nobody is told if not. */
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
     * A robot that has received only a part of a command waits for the rest, for ever (specification, "Roomba Open
     * Interface Commands"). Repeated Start commands complete whatever it is: they are no valid data for a change of the
     * baud rate, and as commands do no harm to a robot that is not under control.
     */
    void completeWhateverIsPending() {
        byte[] starts = new byte[LONGEST_COMMAND];
        Arrays.fill(starts, (byte) Opcode.START.code());
        trySend(starts);
    }

    /** How long the bytes that {@link #completeWhateverIsPending()} sends are on the line. */
    static Duration completionTime(int baud) {
        return Duration.ofNanos(LONGEST_COMMAND * BITS_PER_BYTE * 1_000_000_000L / baud);
    }

    /** Pulls the wake line low or lets it go high again; returns whether the link has one. */
    boolean setWakeLine(boolean low) {
        Link current = link;
        return current != null && current.wakeLine().setLow(low);
    }

    String description() {
        Link current = link;
        return current == null ? "no link" : current.description();
    }
}
