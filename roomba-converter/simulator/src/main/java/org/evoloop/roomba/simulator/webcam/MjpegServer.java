package org.evoloop.roomba.simulator.webcam;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpHandler;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.OutputStream;
import java.net.BindException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Properties;
import java.util.concurrent.atomic.AtomicInteger;
import org.evoloop.roomba.simulator.webcam.Newest.Numbered;
import org.evoloop.time.Clock;
import org.evoloop.time.RequestThreads;
import org.evoloop.time.SystemClock;
import org.jspecify.annotations.Nullable;

/**
 * Serves JPEGs over HTTP, on this machine only: {@value #STREAM} is an endless stream, {@value #FRAME} the next
 * picture, {@code /} a page with the stream. Each client has a thread that sends it the newest picture when it has
 * received the previous one, so a slow client does not delay others. A request that is incomplete after {@value
 * #REQUEST_SECONDS} s, or earlier if its thread is needed, is closed, and so is the connection of a client that does not
 * take a picture in that time. A new connection is closed at once if {@value #MOST_CONNECTIONS} are open, or if {@value #MOST_CLIENTS} clients and {@value
 * #MOST_REQUESTS} requests use all threads.
 */
final class MjpegServer implements AutoCloseable {
    static final String STREAM = "/stream";
    static final String FRAME = "/frame.jpg";

    private static final int MOST_CLIENTS = 16;
    private static final int MOST_REQUESTS = 32;
    private static final int MOST_CONNECTIONS = 512;
    private static final int REQUEST_SECONDS = 10;
    private static final Duration LIMIT = Duration.ofSeconds(REQUEST_SECONDS);
    private static final int ONLY_GET = 405;
    private static final int NOT_FOUND = 404;
    private static final int GONE = 410;
    private static final int BUSY = 503;
    private static final int OK = 200;
    private static final String BOUNDARY = "evoloop-frame";
    private static final String PAGE = """
            <!DOCTYPE html>
            <title>Simulated Roomba</title>
            <body style="margin:0;background:#212529;display:grid;place-items:center;height:100vh">
            <img src="/stream" alt="What the simulated robot sees" style="max-width:100%;image-rendering:pixelated">
            """;

    private final Newest<byte[]> pictures;
    private final HttpServer server;
    private final AtomicInteger clients = new AtomicInteger();
    private final Clock clock = new SystemClock();
    private final RequestThreads threads =
            new RequestThreads("roomba-webcam-client", MOST_CLIENTS + MOST_REQUESTS, LIMIT, clock);

    /**
     * Starts serving.
     *
     * @param port 0 for any free port
     * @throws IOException if the port is not available; the message says what to do
     */
    MjpegServer(Newest<byte[]> pictures, int port) throws IOException {
        this.pictures = pictures;
        // The JDK's server reads these once, before it first serves.
        Properties settings = System.getProperties();
        // Otherwise the end of a picture is delayed up to 40 ms until the client has acknowledged the data before it.
        settings.putIfAbsent("sun.net.httpserver.nodelay", "true");
        settings.putIfAbsent("sun.net.httpserver.idleInterval", Integer.toString(REQUEST_SECONDS));
        // How often the server checks for clients that have not started a request, in ms.
        settings.putIfAbsent("sun.net.httpserver.clockTick", "1000");
        settings.putIfAbsent("jdk.httpserver.maxConnections", Integer.toString(MOST_CONNECTIONS));
        try {
            server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), 0);
        } catch (BindException taken) {
            throw new IOException(
                    "the camera's port " + port + " cannot be used (" + taken.getMessage()
                            + "); choose another, or 0 for any that is free",
                    taken);
        }
        server.setExecutor(threads);
        server.createContext("/", exchange -> answer(exchange, "/", this::sendPage));
        server.createContext(STREAM, exchange -> answer(exchange, STREAM, this::sendStream));
        server.createContext(FRAME, exchange -> answer(exchange, FRAME, this::sendPicture));
        server.start();
    }

    int port() {
        return server.getAddress().getPort();
    }

    /** The number of clients waiting for pictures. */
    int clients() {
        return clients.get();
    }

    /**
     * The JDK's server counts a connection until it has sent an answer on it, or this throws an exception. It would
     * count forever one that an exchange closes because the rest of its request cannot be read.
     */
    private void answer(HttpExchange exchange, String path, HttpHandler handler) throws IOException {
        try (exchange) {
            threads.limit(LIMIT);
            if (!exchange.getRequestURI().getPath().equals(path)) {
                sendText(exchange, NOT_FOUND, "text/plain", "there are /, " + STREAM + " and " + FRAME + "\n");
            } else if (!exchange.getRequestMethod().equals("GET")) {
                sendText(exchange, ONLY_GET, "text/plain", "only GET is understood\n");
            } else {
                handler.handle(exchange);
            }
            exchange.getRequestBody().close();
        }
    }

    private void sendPage(HttpExchange exchange) throws IOException {
        sendText(exchange, OK, "text/html", PAGE);
    }

    private static void sendText(HttpExchange exchange, int status, String type, String text) throws IOException {
        send(exchange, status, type + "; charset=utf-8", text.getBytes(StandardCharsets.UTF_8));
    }

    private static void send(HttpExchange exchange, int status, String type, byte[] body) throws IOException {
        exchange.getResponseHeaders().set("Content-Type", type);
        exchange.getResponseHeaders().set("Cache-Control", "no-store");
        // The JDK's server would log a warning about a body to a HEAD request.
        boolean bodiless = exchange.getRequestMethod().equals("HEAD");
        exchange.sendResponseHeaders(status, bodiless ? -1 : body.length);
        if (!bodiless) {
            exchange.getResponseBody().write(body);
        }
    }

    private void sendPicture(HttpExchange exchange) throws IOException {
        watch(exchange, () -> {
            Numbered<byte[]> next = after(pictures.number());
            if (next == null) {
                sendText(exchange, GONE, "text/plain", "there are no more pictures\n");
            } else {
                send(exchange, OK, "image/jpeg", next.thing());
            }
        });
    }

    private void sendStream(HttpExchange exchange) throws IOException {
        watch(exchange, () -> {
            exchange.getResponseHeaders().set("Content-Type", "multipart/x-mixed-replace; boundary=" + BOUNDARY);
            exchange.getResponseHeaders().set("Cache-Control", "no-store");
            exchange.sendResponseHeaders(OK, 0);
            try (OutputStream body = exchange.getResponseBody()) {
                body.flush();
                @Nullable Numbered<byte[]> next = after(pictures.number());
                while (next != null) {
                    String head = "--" + BOUNDARY + "\r\nContent-Type: image/jpeg\r\nContent-Length: "
                            + next.thing().length + "\r\n\r\n";
                    body.write(head.getBytes(StandardCharsets.US_ASCII));
                    body.write(next.thing());
                    body.write('\r');
                    body.write('\n');
                    body.flush();
                    next = after(next.number());
                }
            }
        });
    }

    /** Waits for the camera as long as it takes; the client then has a limited time to take the picture. */
    private @Nullable Numbered<byte[]> after(long number) throws InterruptedException {
        threads.unlimited();
        Numbered<byte[]> next = pictures.after(number);
        threads.limit(LIMIT);
        return next;
    }

    private interface Show {
        void run() throws IOException, InterruptedException;
    }

    private void watch(HttpExchange exchange, Show show) throws IOException {
        try {
            if (clients.incrementAndGet() > MOST_CLIENTS) {
                sendText(exchange, BUSY, "text/plain", MOST_CLIENTS + " clients is the most that this camera serves\n");
            } else {
                show.run();
            }
        } catch (InterruptedException ending) {
            Thread.currentThread().interrupt();
        } finally {
            clients.decrementAndGet();
        }
    }

    /** Disconnects all clients and frees the port. */
    @Override
    public void close() {
        server.stop(0);
        threads.close();
        clock.close();
    }
}
