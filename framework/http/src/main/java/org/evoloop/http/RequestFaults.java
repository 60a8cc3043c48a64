package org.evoloop.http;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Logs requests that went wrong, the first of each kind as a warning: a client that keeps sending them must not fill
 * the log.
 *
 * <p>Threading: thread-safe.
 */
final class RequestFaults {
    private static final Logger LOG = LoggerFactory.getLogger(HttpMonitor.class);
    private static final int LONGEST_PATH = 100;

    private final AtomicBoolean malformed = new AtomicBoolean();
    private final AtomicBoolean failed = new AtomicBoolean();

    /** The client's request is malformed. */
    void malformed(HttpExchange exchange, IOException why) {
        report(malformed, exchange, "is malformed: " + why.getMessage(), null);
    }

    /** The request was not handled because of a bug in the program. */
    void failed(HttpExchange exchange, RuntimeException mistake) {
        report(failed, exchange, "could not be handled", mistake);
    }

    private static void report(
            AtomicBoolean reported, HttpExchange exchange, String what, @Nullable RuntimeException mistake) {
        String path = exchange.getRequestURI().getPath();
        String request = exchange.getRequestMethod() + " " + path.substring(0, Math.min(path.length(), LONGEST_PATH));
        if (reported.compareAndSet(false, true)) {
            LOG.warn("a client's request {} {}; further ones are not reported", request, what, mistake);
        } else {
            LOG.debug("a client's request {} {}", request, what, mistake);
        }
    }
}
