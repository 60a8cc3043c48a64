package org.evoloop.service;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.evoloop.time.Clock;
import org.evoloop.time.Threads;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The control socket: accepts commands, one per line, and answers each with a {@link Reply}.
 *
 * <p>No client delays another. One thread reads all of them without blocking. At most {@value #CLIENTS} are connected,
 * each with one command in progress. A further client replaces the one that has been idle longest.
 *
 * <p>Threading: connections belong to the server's own thread; commands run on separate threads.
 */
final class ControlServer implements AutoCloseable {
    static final int CLIENTS = 32;

    private static final Logger LOG = LoggerFactory.getLogger(ControlServer.class);
    private static final int BACKLOG = 128;
    private static final Duration END_LIMIT = Duration.ofSeconds(2);

    private final Path path;
    private final Commands commands;
    private final Clock clock;
    private final Selector selector;
    private final ServerSocketChannel door;
    private final SelectionKey doorKey;
    private final Thread thread = new Thread(this::serve, "evoloop-control");
    private final Queue<Runnable> tasks = new ConcurrentLinkedQueue<>();

    /** One thread for each command in progress; a cached pool, so idle threads end after a while. */
    private final ExecutorService workers;

    /** In order of idleness, longest first. */
    private final Set<ControlConnection> connections = new LinkedHashSet<>();

    private volatile boolean closing;

    /**
     * Opens the socket, replacing any existing file.
     *
     * @param path in a private directory
     * @param clock for the deadlines of clients
     */
    ControlServer(Path path, Commands commands, Clock clock) throws IOException {
        this.path = path;
        this.commands = commands;
        this.clock = clock;
        this.workers = Executors.newCachedThreadPool(task -> {
            Thread worker = new Thread(task, "evoloop-control-command");
            worker.setDaemon(true);
            return worker;
        });
        Files.deleteIfExists(path);
        selector = Selector.open();
        door = ServerSocketChannel.open(StandardProtocolFamily.UNIX);
        door.bind(UnixDomainSocketAddress.of(path), BACKLOG);
        Files.setPosixFilePermissions(path, PosixFilePermissions.fromString("rw-------"));
        door.configureBlocking(false);
        doorKey = door.register(selector, SelectionKey.OP_ACCEPT);
        thread.setDaemon(true);
        thread.start();
    }

    Clock clock() {
        return clock;
    }

    Commands commands() {
        return commands;
    }

    /** Runs {@code task} on the server's thread. */
    void later(Runnable task) {
        tasks.add(task);
        selector.wakeup();
    }

    /** Runs {@code command} on a separate thread. */
    void work(Runnable command) {
        workers.execute(command);
    }

    private void serve() {
        while (!closing) {
            try {
                selector.select(this::serve);
                for (Runnable task = tasks.poll(); task != null; task = tasks.poll()) {
                    task.run();
                }
            } catch (IOException | RuntimeException failure) {
                LOG.warn("the control socket {}: {}", path, failure.getMessage());
            }
        }
        List.copyOf(connections).forEach(ControlConnection::drop);
    }

    private void serve(SelectionKey key) {
        if (key.attachment() instanceof ControlConnection connection) {
            connection.advance();
        } else if (hasRoom()) {
            admit();
        } else {
            // Every client has a command in progress; a new one waits until one of them is done.
            key.interestOps(0);
        }
    }

    private boolean hasRoom() {
        if (connections.size() >= CLIENTS) {
            connections.stream().filter(ControlConnection::isIdle).findFirst().ifPresent(ControlConnection::drop);
        }
        return connections.size() < CLIENTS;
    }

    private void admit() {
        try {
            SocketChannel channel = door.accept();
            if (channel != null) {
                channel.configureBlocking(false);
                ControlConnection connection = new ControlConnection(this, channel, selector);
                connections.add(connection);
                connection.advance();
            }
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    /** Marks this connection as the most recently used. */
    void served(ControlConnection connection) {
        if (connections.remove(connection)) {
            connections.add(connection);
        }
        doorKey.interestOps(SelectionKey.OP_ACCEPT);
    }

    void gone(ControlConnection connection) {
        connections.remove(connection);
        doorKey.interestOps(SelectionKey.OP_ACCEPT);
    }

    /** Removes the socket and ends all connections. Idempotent. */
    @Override
    public void close() {
        try {
            Files.deleteIfExists(path);
        } catch (IOException failure) {
            LOG.warn("the control socket {} cannot be removed: {}", path, failure.getMessage());
        }
        later(() -> closing = true);
        if (!Threads.join(thread, END_LIMIT)) {
            LOG.warn("thread {} did not end within {} ms", thread.getName(), END_LIMIT.toMillis());
        }
        // A client may start a command until the server's thread has ended.
        workers.shutdownNow();
        try {
            door.close();
            selector.close();
        } catch (IOException failure) {
            LOG.warn("the control socket {}: {}", path, failure.getMessage());
        }
    }
}
