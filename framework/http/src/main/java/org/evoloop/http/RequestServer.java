package org.evoloop.http;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.InputStream;
import java.io.InterruptedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ProtocolException;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.TreeSet;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Function;
import org.evoloop.evolution.EventOutcome;
import org.evoloop.evolution.Values;
import org.evoloop.time.Clock;
import org.evoloop.time.RequestThreads;
import org.evoloop.time.SystemClock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Listens for requests. At most {@value #MOST_REQUESTS} are handled at once; the connection of a request that is
 * incomplete after {@value #REQUEST_SECONDS} s, or earlier if its thread is needed, is closed.
 *
 * <p>Threading: thread-safe. Each request occupies a thread while it is handled.
 */
final class RequestServer implements AutoCloseable {
    static final int MOST_REQUESTS = 32;

    private static final Logger LOG = LoggerFactory.getLogger(HttpMonitor.class);
    private static final int REQUEST_SECONDS = 10;
    private static final Duration LIMIT = Duration.ofSeconds(REQUEST_SECONDS);
    private static final int HANDLED = 200;
    private static final int ACCEPTED = 202;
    private static final int NO_CONTENT = 204;
    private static final int BAD_REQUEST = 400;
    private static final int NO_TOKEN = 401;
    private static final int TURNED_AWAY = 403;
    private static final int NOT_FOUND = 404;
    private static final int REFUSED = 409;

    private final Door door;
    private final Map<String, Function<Values, @Nullable CompletableFuture<EventOutcome>>> requests;
    private final HttpServer server;
    private final RequestFaults faults = new RequestFaults();
    private final Clock clock = new SystemClock();
    private final RequestThreads threads = new RequestThreads("evoloop-http", MOST_REQUESTS, LIMIT, clock);

    private RequestServer(
            Door door,
            HttpServer server,
            Map<String, Function<Values, @Nullable CompletableFuture<EventOutcome>>> requests) {
        this.door = door;
        this.requests = requests;
        this.server = server;
        server.setExecutor(threads);
        server.createContext("/", this::handle);
    }

    static RequestServer open(
            Door door, int port, Map<String, Function<Values, @Nullable CompletableFuture<EventOutcome>>> requests)
            throws IOException {
        // The JDK's server reads these once, before it serves for the first time; the live page sets the same values.
        Properties settings = System.getProperties();
        settings.putIfAbsent("sun.net.httpserver.nodelay", "true");
        // How long a request may take is not among them: the server would need a thread for that, all the time.
        settings.putIfAbsent("sun.net.httpserver.idleInterval", Integer.toString(REQUEST_SECONDS));
        settings.putIfAbsent("sun.net.httpserver.clockTick", "1000");
        settings.putIfAbsent("jdk.httpserver.maxConnections", "512");
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
            RequestValues.skipRest(request);
        } catch (ProtocolException malformed) {
            faults.malformed(exchange, malformed);
            throw malformed;
        } catch (RuntimeException failure) {
            faults.failed(exchange, failure);
            throw failure;
        }
    }

    private void letIn(HttpExchange exchange) throws IOException {
        String path = exchange.getRequestURI().getPath();
        Function<Values, @Nullable CompletableFuture<EventOutcome>> handler =
                requests.get(exchange.getRequestMethod() + " " + path);
        if (door.isFromAPage(exchange.getRequestHeaders())) {
            answer(
                    exchange,
                    TURNED_AWAY,
                    "requests of web pages are refused; a program addresses this computer as 127.0.0.1 or localhost");
        } else if (!door.knowsToken(exchange.getRequestHeaders())) {
            exchange.getResponseHeaders().set("WWW-Authenticate", "Bearer");
            answer(exchange, NO_TOKEN, "a token is needed, as Authorization: Bearer TOKEN");
        } else if (handler == null) {
            answer(exchange, NOT_FOUND, "known are: " + String.join(", ", new TreeSet<>(requests.keySet())));
        } else {
            Values values = RequestValues.of(exchange);
            threads.limit(LIMIT);
            CompletableFuture<EventOutcome> outcome = handler.apply(values);
            if (outcome == null) {
                exchange.sendResponseHeaders(NO_CONTENT, -1);
            } else {
                tell(exchange, outcome);
            }
        }
    }

    private void tell(HttpExchange exchange, CompletableFuture<EventOutcome> submitted) throws IOException {
        boolean waits =
                !exchange.getRequestHeaders().getOrDefault("Prefer", List.of()).contains("respond-async");
        EventOutcome outcome = null;
        try {
            threads.unlimited();
            outcome = submitted.get(waits ? LIMIT.toMillis() : 0, TimeUnit.MILLISECONDS);
        } catch (TimeoutException later) {
            LOG.debug("the outcome is not known yet", later);
        } catch (ExecutionException | InterruptedException end) {
            throw new InterruptedIOException("the wait for the outcome of an event was ended: " + end);
        } finally {
            threads.limit(LIMIT);
        }
        if (outcome == null) {
            answer(exchange, ACCEPTED, "accepted; the outcome is not known yet");
        } else {
            answer(exchange, outcome.isHandled() ? HANDLED : REFUSED, outcome.toString());
        }
    }

    private static void answer(HttpExchange exchange, int status, String text) throws IOException {
        byte[] body = (text + "\n").getBytes(StandardCharsets.UTF_8);
        exchange.getResponseHeaders().set("Content-Type", "text/plain; charset=utf-8");
        // The JDK's server would log a warning about a body to a HEAD request.
        boolean bodiless = exchange.getRequestMethod().equals("HEAD");
        exchange.sendResponseHeaders(status, bodiless ? -1 : body.length);
        if (!bodiless) {
            exchange.getResponseBody().write(body);
        }
    }

    /** Idempotent. */
    @Override
    public void close() {
        server.stop(0);
        threads.close();
        clock.close();
    }
}
