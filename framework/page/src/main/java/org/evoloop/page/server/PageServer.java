package org.evoloop.page.server;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpHandler;
import com.sun.net.httpserver.HttpServer;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InterruptedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Properties;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Semaphore;
import java.util.function.Supplier;
import org.evoloop.time.Clock;
import org.evoloop.time.RequestThreads;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Serves a page, to at most {@value #MOST_VIEWERS} viewers and {@value #MOST_REQUESTS} other requests at once. It
 * closes the connection of any further client, of a request that is incomplete after {@value #REQUEST_SECONDS} s, or
 * earlier if its thread is needed, and of a client that does not take its answer.
 *
 * <p>Threading: thread-safe. Each request has a thread while it is handled; without requests, there are only the
 * two waiting threads of the JDK's server.
 *
 * @since 0.1
 */
public final class PageServer implements AutoCloseable {
    /** How many streams there may be. */
    public static final int MOST_VIEWERS = 16;
    /** How many other requests there may be at once. */
    public static final int MOST_REQUESTS = 32;

    private static final int REQUEST_SECONDS = 10;
    private static final Duration ANSWER_LIMIT = Duration.ofSeconds(30);
    private static final Logger LOG = LoggerFactory.getLogger(PageServer.class);

    private final HttpServer server;
    private final int longest;
    private final Gate gate;
    private final RequestThreads threads;
    private final Semaphore seats = new Semaphore(MOST_VIEWERS);
    private final Set<String> failed = ConcurrentHashMap.newKeySet();

    /** Handles a request that the gate has admitted. */
    public interface Handler {
        /** Answers it. */
        void handle(HttpExchange exchange) throws IOException, InterruptedException;
    }

    /**
     * Opens the port; nothing is answered before {@link #start}.
     *
     * @param longest how many bytes a request may have
     * @param clock in real time; it stays open
     * @throws IOException if the address cannot be used; the message says what to do
     */
    public PageServer(ServerPlace place, int longest, Clock clock) throws IOException {
        this.longest = longest;
        // The JDK's server reads this once, before it first serves. How long a request may take is not among it, since
        // the server would need another thread for that, all the time.
        Properties settings = System.getProperties();
        settings.putIfAbsent("sun.net.httpserver.nodelay", "true");
        settings.putIfAbsent("sun.net.httpserver.idleInterval", Integer.toString(REQUEST_SECONDS));
        settings.putIfAbsent("sun.net.httpserver.clockTick", "1000");
        // A connection without a request costs no thread; many of them must not keep others from connecting.
        settings.putIfAbsent("jdk.httpserver.maxConnections", "512");
        threads = new RequestThreads(
                "evoloop-page", MOST_VIEWERS + MOST_REQUESTS, Duration.ofSeconds(REQUEST_SECONDS), clock);
        try {
            InetAddress address = InetAddress.getByName(place.host());
            server = HttpServer.create(new InetSocketAddress(address, place.port()), 0);
        } catch (UnknownHostException unknown) {
            throw new IOException(
                    place.option() + ": there is no host " + place.host()
                            + "; leave it out, or use an address of this machine",
                    unknown);
        } catch (IOException taken) {
            throw new IOException(
                    place.option() + ": " + place.host() + ":" + place.port() + " cannot be used (" + taken.getMessage()
                            + "); choose another port, or 0 for any that is free",
                    taken);
        }
        try {
            this.gate = new Gate(place.host(), port(), token(place));
        } catch (IOException | RuntimeException refused) {
            server.stop(0);
            threads.close();
            throw refused;
        }
        server.setExecutor(threads);
    }

    private static String token(ServerPlace place) throws IOException {
        TokenFile file = place.tokenFile();
        if (file == null) {
            return Gate.secret();
        }
        Optional<String> kept = file.read();
        if (kept.isPresent()) {
            return kept.get();
        }
        String token = Gate.secret();
        file.write(token);
        return token;
    }

    /** The port on which it listens. */
    public int port() {
        return server.getAddress().getPort();
    }

    /** Who is let in. */
    public Gate gate() {
        return gate;
    }

    /** The threads of the requests. */
    public RequestThreads threads() {
        return threads;
    }

    /** Sets the handler of {@code method} requests for exactly {@code path}; that of GET also answers HEAD. */
    public void on(String method, String path, Handler handler) {
        serve(path, method.equals("GET") ? List.of("GET", "HEAD") : List.of(method), handler);
    }

    /** Sets the handler of a stream to a viewer, if there is room for one. */
    public void onStream(String path, Handler handler) {
        serve(path, List.of("GET"), exchange -> {
            if (!seats.tryAcquire()) {
                Answer.text(exchange, Answer.BUSY, MOST_VIEWERS + " viewers are the maximum");
                return;
            }
            try {
                handler.handle(exchange);
            } finally {
                seats.release();
            }
        });
    }

    /** Serves a file at {@code path}, whose content is opened at each request; without any there is no such path. */
    public void file(String path, String mediaType, Supplier<@Nullable InputStream> content) {
        on("GET", path, exchange -> {
            try (InputStream file = content.get()) {
                if (file == null) {
                    notFound(exchange);
                } else {
                    Answer.send(exchange, Answer.OK, mediaType, file.readAllBytes());
                }
            }
        });
    }

    /**
     * Exchanges the token for the cookie, at {@code /session}.
     *
     * @param welcome what one gets who has the token, as JSON
     */
    public void session(Supplier<String> welcome) {
        on("POST", "/session", exchange -> {
            String cookie = gate.admit(body(exchange).strip());
            if (cookie == null) {
                Answer.notAdmitted(exchange);
            } else {
                exchange.getResponseHeaders().set("Set-Cookie", cookie);
                Answer.json(exchange, welcome.get());
            }
        });
    }

    /** Sets the handler of all requests whose path begins with {@code prefix}, from those who have the cookie. */
    public void admitted(String prefix, Handler handler) {
        serve(prefix, exchange -> {
            if (gate.isAdmitted(exchange)) {
                handle(exchange, handler);
            } else {
                Answer.notAdmitted(exchange);
            }
        });
    }

    /** The text of a request. */
    public static String body(HttpExchange exchange) throws IOException {
        return new String(exchange.getRequestBody().readAllBytes(), StandardCharsets.UTF_8);
    }

    private static void notFound(HttpExchange exchange) throws IOException {
        Answer.text(
                exchange,
                Answer.NOT_FOUND,
                "there is no " + exchange.getRequestURI().getPath());
    }

    private void serve(String path, List<String> methods, Handler handler) {
        serve(path, exchange -> {
            if (!exchange.getRequestURI().getPath().equals(path)) {
                notFound(exchange);
            } else if (!methods.contains(exchange.getRequestMethod())) {
                exchange.getResponseHeaders().set("Allow", String.join(", ", methods));
                Answer.text(exchange, Answer.OTHER_METHOD, "only " + methods.get(0) + " is understood");
            } else {
                handle(exchange, handler);
            }
        });
    }

    private static void handle(HttpExchange exchange, Handler handler) throws IOException {
        try {
            handler.handle(exchange);
        } catch (InterruptedException late) {
            Thread.currentThread().interrupt();
            throw new InterruptedIOException("it took too long");
        }
    }

    /**
     * Sets the handler of requests that the gate has admitted. They have been read.
     *
     * <p>The JDK's server counts a connection until it has sent an answer on it, or this throws an exception. It would
     * count forever one that an exchange closes because the rest of its request cannot be read.
     */
    private void serve(String path, HttpHandler handler) {
        server.createContext(path, exchange -> {
            try (exchange) {
                InputStream request = exchange.getRequestBody();
                byte[] body = request.readNBytes(longest + 1);
                threads.limit(ANSWER_LIMIT);
                String objection = gate.objection(exchange);
                if (objection != null) {
                    Answer.text(exchange, Answer.TURNED_AWAY, objection);
                } else if (body.length > longest) {
                    Answer.text(exchange, Answer.TOO_LARGE, "a request has at most " + longest + " bytes");
                } else {
                    exchange.setStreams(new ByteArrayInputStream(body), null);
                    answer(exchange, path, handler);
                }
                request.close();
            }
        });
    }

    private void answer(HttpExchange exchange, String path, HttpHandler handler) throws IOException {
        try {
            handler.handle(exchange);
        } catch (RuntimeException | Error failure) {
            report(path, failure);
            if (exchange.getResponseCode() >= 0) {
                throw failure;
            }
            Answer.text(exchange, Answer.FAILED, "the program has failed at this; its log says why");
        }
    }

    /** The browser asks again and again, which must not fill the log. */
    private void report(String path, Throwable failure) {
        if (failed.add(path)) {
            LOG.warn("the page cannot answer {}; further failures of it are not reported", path, failure);
        } else {
            LOG.debug("the page cannot answer {}", path, failure);
        }
    }

    /** Answers requests from now on. */
    public void start() {
        server.start();
    }

    /** Closes all connections and frees the port. Idempotent. */
    @Override
    public void close() {
        server.stop(0);
        threads.close();
    }
}
