package org.evoloop.http;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ProtocolException;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import org.evoloop.evolution.Values;
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
    private static final int IDLE_SECONDS = 5;
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
    private final ThreadPoolExecutor threads =
            new ThreadPoolExecutor(0, MOST_REQUESTS, IDLE_SECONDS, TimeUnit.SECONDS, new SynchronousQueue<>(), task -> {
                Thread thread = new Thread(task, "evoloop-http");
                thread.setDaemon(true);
                return thread;
            });

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
        unlessSet("sun.net.httpserver.maxReqTime", "10");
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

    private void handle(HttpExchange exchange) throws IOException {
        try (exchange) {
            try {
                letIn(exchange);
            } catch (IllegalArgumentException wrong) {
                answer(exchange, BAD_REQUEST, String.valueOf(wrong.getMessage()));
            } catch (IllegalStateException stopped) {
                answer(exchange, REFUSED, String.valueOf(stopped.getMessage()));
            }
        } catch (ProtocolException malformed) {
            String path = exchange.getRequestURI().getPath();
            warnOnce(
                    exchange.getRequestMethod() + " " + path.substring(0, Math.min(path.length(), LONGEST_PATH)),
                    malformed);
        } catch (RuntimeException failure) {
            LOG.warn(
                    "the request {} could not be handled",
                    exchange.getRequestURI().getPath(),
                    failure);
        }
    }

    /** A client that keeps sending such requests must not fill the log. */
    private void warnOnce(String request, ProtocolException malformed) {
        if (malformedReported.compareAndSet(false, true)) {
            LOG.warn(
                    "a client's request {} is malformed: {}; further ones are not reported",
                    request,
                    malformed.getMessage());
        } else {
            LOG.debug("request {} is malformed", request, malformed);
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
        threads.shutdownNow();
    }
}
