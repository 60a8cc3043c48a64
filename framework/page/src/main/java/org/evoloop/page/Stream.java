package org.evoloop.page;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import org.evoloop.page.server.Answer;
import org.evoloop.time.Clock;
import org.evoloop.time.RequestThreads;

/**
 * One viewer: server-sent events, each with the newest status and the events that have ended since the last one. A
 * stream ends after some minutes, and a browser that is still there starts another, so vanished ones are forgotten.
 *
 * <p>Threading: belongs to the thread that serves the viewer.
 */
final class Stream {
    private static final Duration LONGEST = Duration.ofMinutes(5);
    private static final Duration TO_TAKE_ONE = Duration.ofSeconds(10);
    private static final Duration TO_BE_HEARD = Duration.ofSeconds(3);

    private final Broadcast broadcast;
    private final RequestThreads threads;
    private final Clock clock;

    Stream(Broadcast broadcast, RequestThreads threads, Clock clock) {
        this.broadcast = broadcast;
        this.threads = threads;
        this.clock = clock;
    }

    /** Serves until the viewer leaves, or takes too long to take an update. */
    void serve(HttpExchange exchange) throws IOException, InterruptedException {
        // A proxy, such as nginx, would otherwise collect updates before it passes them on.
        Answer.headers(exchange, "text/event-stream").set("X-Accel-Buffering", "no");
        exchange.sendResponseHeaders(Answer.OK, 0);
        broadcast.join();
        // Closing the exchange would close the body, too, but hide it if that fails.
        try (OutputStream body = exchange.getResponseBody()) {
            stream(body);
        } finally {
            broadcast.leave();
        }
    }

    private void stream(OutputStream body) throws IOException, InterruptedException {
        long begun = clock.nanoTime();
        long written = begun;
        String before = "";
        Broadcast.Update update = broadcast.after(-1, Long.MAX_VALUE);
        write(body, "retry: 500\n\n");
        while (clock.nanoTime() - begun < LONGEST.toNanos()) {
            String status = update.status().toString();
            if (!update.events().isEmpty() || !status.equals(before)) {
                write(body, "data: " + update.json() + "\n\n");
                written = clock.nanoTime();
            } else if (clock.nanoTime() - written >= TO_BE_HEARD.toNanos()) {
                write(body, ": here\n\n");
                written = clock.nanoTime();
            }
            before = status;
            update = broadcast.after(update.number(), update.last());
        }
        threads.limit(TO_TAKE_ONE);
    }

    private void write(OutputStream body, String text) throws IOException {
        threads.limit(TO_TAKE_ONE);
        body.write(text.getBytes(StandardCharsets.UTF_8));
        body.flush();
        threads.unlimited();
    }
}
