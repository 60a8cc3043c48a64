package org.evoloop.page;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpHandler;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.time.Duration;
import java.util.concurrent.Semaphore;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import org.evoloop.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Serves a page, to at most {@value #MOST_VIEWERS} viewers and {@value #MOST_REQUESTS} other requests at once. It
 * closes the connection of any further client, of a request that is incomplete after {@value #REQUEST_SECONDS} s, and
 * of a client that does not take its answer.
 *
 * <p>Threading: thread-safe. Each request has a thread while it is handled; without requests, there are only the
 * waiting threads of the JDK's server.
 */
final class PageServer implements AutoCloseable {
    static final int MOST_VIEWERS = 16;
    static final int MOST_REQUESTS = 16;

    private static final int REQUEST_SECONDS = 10;
    private static final Duration ANSWER_LIMIT = Duration.ofSeconds(30);
    private static final int IDLE_SECONDS = 5;
    private static final Logger LOG = LoggerFactory.getLogger(PageServer.class);

    private final HttpServer server;
    private final Gate gate;
    private final Deadlines deadlines;
    private final Semaphore seats = new Semaphore(MOST_VIEWERS);
    private final ThreadPoolExecutor threads = new ThreadPoolExecutor(
            0, MOST_VIEWERS + MOST_REQUESTS, IDLE_SECONDS, TimeUnit.SECONDS, new SynchronousQueue<>(), task -> {
                Thread thread = new Thread(task, "evoloop-page");
                thread.setDaemon(true);
                return thread;
            });

    /** Handles a request that the gate has admitted. */
    interface Handler {
        void handle(HttpExchange exchange) throws IOException, InterruptedException;
    }

    /** @throws IOException if the address cannot be used; the message says what to do */
    PageServer(PageOptions options, Clock clock) throws IOException {
        // The JDK's server reads this once, before it first serves.
        unlessSet("sun.net.httpserver.nodelay", "true");
        unlessSet("sun.net.httpserver.maxReqTime", Integer.toString(REQUEST_SECONDS));
        unlessSet("sun.net.httpserver.clockTick", "1000");
        unlessSet("jdk.httpserver.maxConnections", "64");
        this.deadlines = new Deadlines(clock);
        try {
            InetAddress address = InetAddress.getByName(options.host());
            server = HttpServer.create(new InetSocketAddress(address, options.port()), 0);
        } catch (UnknownHostException unknown) {
            throw new IOException(
                    "--page: there is no host " + options.host() + "; leave it out, or use an address of this machine",
                    unknown);
        } catch (IOException taken) {
            throw new IOException(
                    "--page: " + options.host() + ":" + options.port() + " cannot be used (" + taken.getMessage()
                            + "); choose another port, or 0 for any that is free",
                    taken);
        }
        this.gate = new Gate(options.host(), port());
        server.setExecutor(threads);
    }

    private static void unlessSet(String property, String value) {
        if (System.getProperty(property) == null) {
            System.setProperty(property, value);
        }
    }

    int port() {
        return server.getAddress().getPort();
    }

    Gate gate() {
        return gate;
    }

    Deadlines deadlines() {
        return deadlines;
    }

    /** The number of threads that handle requests. */
    int threads() {
        return threads.getActiveCount();
    }

    /** Sets the handler of {@code method} requests for exactly {@code path}. */
    void on(String method, String path, Handler handler) {
        serve(path, exchange -> {
            if (!exchange.getRequestURI().getPath().equals(path)) {
                Answer.text(
                        exchange,
                        Answer.NOT_FOUND,
                        "there is no " + exchange.getRequestURI().getPath());
            } else if (!exchange.getRequestMethod().equals(method)) {
                exchange.getResponseHeaders().set("Allow", method);
                Answer.text(exchange, Answer.OTHER_METHOD, "only " + method + " is understood");
            } else {
                limited(exchange, handler);
            }
        });
    }

    /** Sets the handler of a stream to a viewer, if there is room for one. */
    void onStream(String path, Handler handler) {
        serve(path, exchange -> {
            if (!seats.tryAcquire()) {
                Answer.text(exchange, Answer.BUSY, MOST_VIEWERS + " viewers are the maximum");
                return;
            }
            try {
                handler.handle(exchange);
            } catch (InterruptedException hungUp) {
                LOG.debug("a slow viewer was disconnected", hungUp);
            } finally {
                seats.release();
            }
        });
    }

    private void limited(HttpExchange exchange, Handler handler) throws IOException {
        deadlines.begin(ANSWER_LIMIT);
        try {
            handler.handle(exchange);
        } catch (InterruptedException hungUp) {
            LOG.debug("a request took too long", hungUp);
        } finally {
            deadlines.end();
        }
    }

    private void serve(String path, HttpHandler handler) {
        server.createContext(path, exchange -> {
            try (exchange) {
                String objection = gate.objection(exchange);
                if (objection != null) {
                    Answer.text(exchange, Answer.TURNED_AWAY, objection);
                } else {
                    handler.handle(exchange);
                }
            } catch (RuntimeException failure) {
                LOG.warn("the page cannot answer {}", exchange.getRequestURI().getPath(), failure);
            }
        });
    }

    void start() {
        server.start();
    }

    /** Closes all connections and frees the port. Idempotent. */
    @Override
    public void close() {
        deadlines.close();
        server.stop(0);
        threads.shutdownNow();
    }
}
