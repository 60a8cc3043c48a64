package org.evoloop.line;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;

/** A TCP server for lines: it records those that it receives, and sends predefined answers. */
final class LineServer implements AutoCloseable {
    static final int PATIENCE_SECONDS = 20;

    /** The answers by line; for an empty one it closes the connection. */
    final Map<String, String> answers = new ConcurrentHashMap<>();

    final BlockingQueue<String> heard = new LinkedBlockingQueue<>();
    private final BlockingQueue<Socket> clients = new LinkedBlockingQueue<>();
    private final List<Socket> all = new CopyOnWriteArrayList<>();
    private final ServerSocket server;

    LineServer() throws IOException {
        this(0);
    }

    /** @param port 0 for any free port */
    LineServer(int port) throws IOException {
        server = new ServerSocket(port, 50, InetAddress.getLoopbackAddress());
        Threads.start("line-server", this::serve);
    }

    int port() {
        return server.getLocalPort();
    }

    LineTransport transport() {
        return LineTransport.tcp("127.0.0.1", port());
    }

    private void serve() {
        try {
            while (true) {
                Socket client = server.accept();
                all.add(client);
                clients.add(client);
                Threads.start("line-server-client", () -> read(client));
            }
        } catch (IOException closed) {
            // The test is over.
        }
    }

    private void read(Socket client) {
        try {
            LineReader lines = new LineReader(client.getInputStream(), about -> {});
            for (String line = lines.next(); line != null; line = lines.next()) {
                heard.add(line);
                String answer = answers.get(line);
                if (answer != null && answer.isEmpty()) {
                    client.close();
                } else if (answer != null) {
                    client.getOutputStream().write((answer + "\r\n").getBytes(StandardCharsets.UTF_8));
                }
            }
        } catch (IOException gone) {
            // The client has closed the connection.
        }
    }

    /** Waits for the next client. */
    Socket client() throws InterruptedException {
        return got(clients.poll(PATIENCE_SECONDS, TimeUnit.SECONDS), "nobody has connected");
    }

    String nextLine() throws InterruptedException {
        return got(heard.poll(PATIENCE_SECONDS, TimeUnit.SECONDS), "no line has come");
    }

    private static <T> T got(@Nullable T what, String otherwise) {
        if (what == null) {
            throw new AssertionError(otherwise);
        }
        return what;
    }

    static void send(Socket client, String text) throws IOException {
        client.getOutputStream().write(text.getBytes(StandardCharsets.UTF_8));
    }

    @Override
    public void close() {
        try {
            server.close();
            for (Socket client : all) {
                client.close();
            }
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }
}
