package org.evoloop.line;

import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.RejectedExecutionException;
import org.evoloop.line.LineTransport.Wire;
import org.evoloop.time.Clock;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Keeps a wire open: opens it, reads it, and opens it again when it is lost.
 *
 * <p>Threading: all methods may be called from any thread; users are called on the reading thread.
 */
final class Reconnector {
    private static final Logger LOG = LoggerFactory.getLogger(LineConnection.class);
    private static final Duration END_LIMIT = Duration.ofSeconds(4);

    private final LineTransport transport;
    private final LineWriter writer;
    private final WireUsers users;
    private final WireHealth health;
    private volatile @Nullable Wire wire;
    /** The reason why this side has hung up; empty if it has not. */
    private volatile String ended = "";

    private volatile boolean closing;
    private @Nullable Thread thread;

    Reconnector(LineTransport transport, Clock clock) {
        this.transport = transport;
        this.health = new WireHealth(transport.toString(), clock);
        this.users = new WireUsers(transport.toString());
        this.writer = new LineWriter(clock, transport.toString(), this::hangUp);
    }

    void add(WireUser user) {
        users.add(user);
    }

    /** Adds a user that learns everything before the others. */
    void addFirst(WireUser user) {
        users.addFirst(user);
    }

    /** The wire's destination, for messages. */
    String place() {
        return transport.toString();
    }

    synchronized void open() {
        if (thread == null) {
            thread = new Thread(this::run, "line-" + transport);
            thread.setDaemon(true);
            thread.start();
        }
    }

    private void run() {
        try {
            while (!closing) {
                serve();
                if (!closing) {
                    health.tryAgain();
                }
            }
        } catch (InterruptedException | RejectedExecutionException end) {
            // This connection is being closed, or its clock was closed.
        }
    }

    private void serve() {
        ended = "";
        String why = transport + " has hung up; check that it runs";
        try (Wire opened = transport.open()) {
            wire = opened;
            if (!closing) {
                read(opened);
            }
        } catch (IOException failure) {
            why = String.valueOf(failure.getMessage());
        }
        wire = null;
        health.down(ended.isEmpty() ? why : ended);
        users.lost(health.trouble());
    }

    private void read(Wire opened) throws IOException {
        health.up();
        users.connected();
        LineReader lines = new LineReader(opened.input(), users::complain);
        for (String line = lines.next(); line != null; line = lines.next()) {
            users.heard(line);
        }
    }

    /** See {@link LineConnection#send}. */
    void write(String line) throws IOException {
        Wire open = wire;
        if (open == null) {
            throw new IOException(health.trouble() + "; so '" + line + "' was not sent");
        }
        writer.write(open, line);
    }

    /** Closes the wire, so that it is opened again. */
    void hangUp(String why) {
        Wire open = wire;
        if (open != null) {
            ended = why;
            try {
                open.close();
            } catch (IOException failure) {
                LOG.debug("{} cannot be closed", transport, failure);
            }
        }
    }

    boolean isUp() {
        return wire != null;
    }

    WireHealth health() {
        return health;
    }

    void close() {
        closing = true;
        hangUp(transport + " is closed");
        Thread running;
        synchronized (this) {
            running = thread;
        }
        if (running != null) {
            running.interrupt();
            if (!Threads.join(running, END_LIMIT)) {
                LOG.warn("{} has not ended within {} s", transport, END_LIMIT.toSeconds());
            }
        }
    }
}
