package org.evoloop.line;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.RejectedExecutionException;
import org.evoloop.line.LineTransport.Wire;
import org.evoloop.time.Attempts;
import org.evoloop.time.Clock;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Keeps a wire: opens it, reads it, and opens another when it is lost.
 *
 * <p>Threading: all methods may be called from any thread; users are called on the thread that reads.
 */
final class Reconnector {
    private static final Logger LOG = LoggerFactory.getLogger(LineConnection.class);
    private static final Duration END_LIMIT = Duration.ofSeconds(4);

    private final LineTransport transport;
    private final Clock clock;
    private final LineWriter writer;
    private final List<WireUser> users = new CopyOnWriteArrayList<>();
    private final Attempts attempts = new Attempts();
    private final Set<String> complaints = new HashSet<>();
    private volatile @Nullable Wire wire;
    private volatile @Nullable Instant downSince;
    private volatile String trouble;
    /** Why this side has hung up; empty if it has not. */
    private volatile String ended = "";

    private volatile boolean closing;
    private @Nullable Thread thread;

    Reconnector(LineTransport transport, Clock clock) {
        this.transport = transport;
        this.clock = clock;
        this.writer = new LineWriter(clock, transport.toString(), this::hangUp);
        this.trouble = transport + " has not been reached yet";
        this.downSince = clock.wallTime();
    }

    void add(WireUser user) {
        users.add(user);
    }

    /** Where it leads, for messages. */
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
                    clock.sleep(attempts.pause());
                }
            }
        } catch (InterruptedException | RejectedExecutionException end) {
            // It is being closed, or its clock was.
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
        if (downSince == null) {
            downSince = clock.wallTime();
        }
        trouble = ended.isEmpty() ? why : ended;
        for (WireUser user : users) {
            user.lost(trouble);
        }
        if (!closing && attempts.failed(trouble, clock.nanoTime())) {
            LOG.warn("{}; it is tried again until it works", trouble);
        }
    }

    private void read(Wire opened) throws IOException {
        downSince = null;
        trouble = "";
        if (attempts.succeeded(clock.nanoTime())) {
            LOG.info("{} is connected", transport);
        }
        for (WireUser user : users) {
            user.connected();
        }
        LineReader lines = new LineReader(opened.input(), this::complain);
        for (String line = lines.next(); line != null; line = lines.next()) {
            hear(line);
        }
    }

    private void hear(String line) {
        for (WireUser user : users) {
            try {
                user.heard(line);
            } catch (RuntimeException failure) {
                LOG.warn("'{}' of {} cannot be dealt with", line, transport, failure);
            }
        }
    }

    private void complain(String about) {
        if (complaints.add(about)) {
            LOG.warn("{}: {}", transport, about);
        }
    }

    /** As {@link LineConnection#tell}. */
    void write(String line) throws IOException {
        Wire open = wire;
        if (open == null) {
            throw new IOException(trouble + "; so '" + line + "' was not sent");
        }
        writer.write(open, line);
    }

    /** Has the wire made anew. */
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

    @Nullable
    Instant downSince() {
        return downSince;
    }

    /** What is wrong; empty if nothing is. */
    String trouble() {
        return trouble;
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
