package org.evoloop.page;

import com.sun.net.httpserver.Headers;
import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.nio.charset.StandardCharsets;

/** Answers a request, with headers that keep other sites and external content out of the page. */
final class Answer {
    static final int OK = 200;
    static final int NO_CONTENT = 204;
    static final int BAD_REQUEST = 400;
    static final int NOT_ADMITTED = 401;
    static final int TURNED_AWAY = 403;
    static final int NOT_FOUND = 404;
    static final int OTHER_METHOD = 405;
    static final int TOO_LARGE = 413;
    static final int BUSY = 503;

    private static final String POLICY = "default-src 'none'; script-src 'self'; style-src 'self'; "
            + "img-src 'self' blob:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

    private Answer() {}

    /** The headers of every answer. */
    static Headers headers(HttpExchange exchange, String mediaType) {
        Headers headers = exchange.getResponseHeaders();
        headers.set("Content-Type", mediaType);
        headers.set("Content-Security-Policy", POLICY);
        headers.set("X-Content-Type-Options", "nosniff");
        headers.set("X-Frame-Options", "DENY");
        headers.set("Referrer-Policy", "no-referrer");
        headers.set("Cross-Origin-Resource-Policy", "same-origin");
        headers.set("Cross-Origin-Opener-Policy", "same-origin");
        headers.set("Cache-Control", "no-store");
        return headers;
    }

    static void send(HttpExchange exchange, int status, String mediaType, byte[] body) throws IOException {
        headers(exchange, mediaType);
        // The JDK's server would log a warning about a body to a HEAD request.
        boolean bodiless = body.length == 0 || exchange.getRequestMethod().equals("HEAD");
        exchange.sendResponseHeaders(status, bodiless ? -1 : body.length);
        if (!bodiless) {
            exchange.getResponseBody().write(body);
        }
    }

    static void text(HttpExchange exchange, int status, String text) throws IOException {
        send(exchange, status, "text/plain; charset=utf-8", (text + "\n").getBytes(StandardCharsets.UTF_8));
    }

    static void json(HttpExchange exchange, String json) throws IOException {
        send(exchange, OK, "application/json", json.getBytes(StandardCharsets.UTF_8));
    }
}
