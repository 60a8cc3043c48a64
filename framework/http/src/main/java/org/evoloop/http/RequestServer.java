package org.evoloop.http;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ProtocolException;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import org.evoloop.evolution.Values;
import org.evoloop.time.Clock;
import org.evoloop.time.RequestThreads;
import org.evoloop.time.SystemClock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Listens for requests.
 *
 * <p>Threading: thread-safe. Each request occupies a thread while it is handled.
 */
final class RequestServer implements AutoCloseable {
    static final int MOST_REQUESTS = 8;

    private static final Logger LOG = LoggerFactory.getLogger(HttpMonitor.class);
    private static final int REQUEST_SECONDS = 10;
    private static final int LONGEST_PATH = 100;
    private static final int NO_CONTENT = 204;
    private static final int BAD_REQUEST = 400;
    private static final int NO_TOKEN = 401;
    private static final int TURNED_AWAY = 403;
    private static final int NOT_FOUND = 404;
    private static final int REFUSED = 409;

    private final Door door;
    private final Map<String, Consumer<Values>> requests;
    private final HttpServer server;
    private final AtomicBoolean malformedReported = new AtomicBoolean();
    private final AtomicBoolean failureReported = new AtomicBoolean();
    private final Clock clock = new SystemClock();
    private final RequestThreads threads =
            new RequestThreads("evoloop-http", MOST_REQUESTS, Duration.ofSeconds(REQUEST_SECONDS), clock);

    private RequestServer(Door door, HttpServer server, Map<String, Consumer<Values>> requests) {
        this.door = door;
        this.requests = requests;
        this.server = server;
        server.setExecutor(threads);
        server.createContext("/", this::handle);
    }

    static RequestServer open(Door door, int port, Map<String, Consumer<Values>> requests) throws IOException {
        // The JDK's server reads these once, before it serves for the first time; the live page sets the same values.
        unlessSet("sun.net.httpserver.nodelay", "true");
        // How long a request may take is not among them: the server would need a thread for that, all the time.
        unlessSet("sun.net.httpserver.idleInterval", Integer.toString(REQUEST_SECONDS));
        unlessSet("sun.net.httpserver.clockTick", "1000");
        unlessSet("jdk.httpserver.maxConnections", "64");
        try {
            InetSocketAddress address = new InetSocketAddress(InetAddress.getByName(door.host()), port);
            RequestServer opened = new RequestServer(door, HttpServer.create(address, 0), requests);
            opened.server.start();
            LOG.info("{} requests are listened for on {}:{}", requests.size(), door.host(), opened.port());
            return opened;
        } catch (UnknownHostException unknown) {
            throw new IOException("there is no host " + door.host() + "; use an address of this machine", unknown);
        } catch (IOException taken) {
            throw new IOException(
                    door.host() + ":" + port + " cannot be listened on (" + taken.getMessage()
                            + "); choose another port, or 0 for any that is free",
                    taken);
        }
    }

    private static void unlessSet(String property, String value) {
        if (System.getProperty(property) == null) {
            System.setProperty(property, value);
        }
    }

    int port() {
        return server.getAddress().getPort();
    }

    /**
     * The JDK's server counts a connection until it has sent an answer on it, or this throws an exception. It would
     * count forever one that an exchange closes because the rest of its request cannot be read.
     */
    private void handle(HttpExchange exchange) throws IOException {
        try (exchange) {
            InputStream request = exchange.getRequestBody();
            try {
                letIn(exchange);
            } catch (IllegalArgumentException wrong) {
                answer(exchange, BAD_REQUEST, String.valueOf(wrong.getMessage()));
            } catch (IllegalStateException stopped) {
                answer(exchange, REFUSED, String.valueOf(stopped.getMessage()));
            }
            skipRest(request);
        } catch (ProtocolException malformed) {
            reportOnce(malformedReported, "is malformed: " + malformed.getMessage(), exchange, null);
            throw malformed;
        } catch (RuntimeException failure) {
            reportOnce(failureReported, "could not be handled", exchange, failure);
            throw failure;
        }
    }

    private static void skipRest(InputStream request) throws IOException {
        try {
            request.close();
        } catch (RuntimeException impossible) {
            throw RequestValues.impossibleChunk(impossible);
        }
    }

    /** A client that keeps sending such requests must not fill the log. */
    private static void reportOnce(
            AtomicBoolean reported, String what, HttpExchange exchange, @Nullable RuntimeException failure) {
        String path = exchange.getRequestURI().getPath();
        String request = exchange.getRequestMethod() + " " + path.substring(0, Math.min(path.length(), LONGEST_PATH));
        if (reported.compareAndSet(false, true)) {
            LOG.warn("a client's request {} {}; further ones are not reported", request, what, failure);
        } else {
            LOG.debug("a client's request {} {}", request, what, failure);
        }
    }

    private void letIn(HttpExchange exchange) throws IOException {
        String path = exchange.getRequestURI().getPath();
        Consumer<Values> handler = requests.get(exchange.getRequestMethod() + " " + path);
        if (door.isFromAPage(exchange.getRequestHeaders())) {
            answer(exchange, TURNED_AWAY, "requests of web pages are refused");
        } else if (!door.knowsToken(exchange.getRequestHeaders())) {
            exchange.getResponseHeaders().set("WWW-Authenticate", "Bearer");
            answer(exchange, NO_TOKEN, "a token is needed, as Authorization: Bearer TOKEN");
        } else if (handler == null) {
            answer(
                    exchange,
                    NOT_FOUND,
                    "known are: "
                            + String.join(
                                    ", ", requests.keySet().stream().sorted().toList()));
        } else {
            handler.accept(RequestValues.of(exchange));
            exchange.sendResponseHeaders(NO_CONTENT, -1);
        }
    }

    private static void answer(HttpExchange exchange, int status, String text) throws IOException {
        byte[] body = (text + "\n").getBytes(StandardCharsets.UTF_8);
        exchange.getResponseHeaders().set("Content-Type", "text/plain; charset=utf-8");
        exchange.sendResponseHeaders(status, body.length);
        exchange.getResponseBody().write(body);
    }

    /** Idempotent. */
    @Override
    public void close() {
        server.stop(0);
        threads.close();
        clock.close();
    }
}
