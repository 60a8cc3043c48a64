package org.evoloop.page.server;

import com.sun.net.httpserver.Headers;
import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.nio.charset.StandardCharsets;

/**
 * Answers a request, with headers that keep other sites and external content out of the page.
 *
 * <p>Threading: for the thread of the request.
 *
 * @since 0.1
 */
public final class Answer {
    /** The answer is here. */
    public static final int OK = 200;
    /** There is nothing. */
    public static final int NO_CONTENT = 204;
    /** The request makes no sense. */
    public static final int BAD_REQUEST = 400;
    /** The token is needed. */
    public static final int NOT_ADMITTED = 401;
    /** The gate, or what is asked for, does not allow it. */
    public static final int TURNED_AWAY = 403;
    /** There is no such thing. */
    public static final int NOT_FOUND = 404;
    /** The method is another one. */
    public static final int OTHER_METHOD = 405;
    /** The request is too large. */
    public static final int TOO_LARGE = 413;
    /** The program could not answer it. */
    public static final int FAILED = 500;
    /** There is no room at the moment. */
    public static final int BUSY = 503;

    private static final String POLICY = "default-src 'none'; script-src 'self'; style-src 'self'; "
            + "img-src 'self' blob:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

    private Answer() {}

    /** The headers of every answer. */
    public static Headers headers(HttpExchange exchange, String mediaType) {
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

    /** Sends a body. */
    public static void send(HttpExchange exchange, int status, String mediaType, byte[] body) throws IOException {
        headers(exchange, mediaType);
        // The JDK's server would log a warning about a body to a HEAD request.
        boolean bodiless = body.length == 0 || exchange.getRequestMethod().equals("HEAD");
        exchange.sendResponseHeaders(status, bodiless ? -1 : body.length);
        if (!bodiless) {
            exchange.getResponseBody().write(body);
        }
    }

    /** Sends a line of text. */
    public static void text(HttpExchange exchange, int status, String text) throws IOException {
        send(exchange, status, "text/plain; charset=utf-8", (text + "\n").getBytes(StandardCharsets.UTF_8));
    }

    /** Says that the token is needed. */
    public static void notAdmitted(HttpExchange exchange) throws IOException {
        text(exchange, NOT_ADMITTED, "this needs the token that the program printed when it started");
    }

    /** Sends JSON. */
    public static void json(HttpExchange exchange, String json) throws IOException {
        send(exchange, OK, "application/json", json.getBytes(StandardCharsets.UTF_8));
    }
}
