package org.evoloop.http;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.Function;
import org.evoloop.converter.PushMonitor;
import org.evoloop.evolution.EventOutcome;
import org.evoloop.evolution.Values;
import org.jspecify.annotations.Nullable;

/**
 * A monitor of a controller or a device that sends HTTP requests:
 *
 * <pre>{@code
 * new HttpMonitor("Buttons", 8090)
 *         .controller("POST /power", "power")
 *         .device("POST /overheated", "overheat")
 *         .open();
 * }</pre>
 *
 * <p>It accepts requests only from this machine, unless {@link #listenOn} is used. Query parameters are the event's
 * values, as numbers if they look like numbers. So is the body, as a text named {@code body}, of at most 4096 bytes.
 * The answer to the controller's requests is the outcome of the event in words, with the status 200 if it was handled, 409
 * if not, and 202 if that is not known after 10 s; a request with the header {@code Prefer: respond-async} is answered
 * with 202 once the event waits. The answer to the device's requests, and where a fleet decides, is 204. At most 32
 * requests are handled at a time; further ones are disconnected, and so are clients that have not sent everything within
 * 10 s. Requests from pages of other sites are refused.
 *
 * <p>Lifecycle: set all requests, then {@link #open}; {@link #close}.
 *
 * <p>Threading: as {@link PushMonitor}.
 *
 * @since 0.1
 */
public class HttpMonitor extends PushMonitor implements AutoCloseable {
    private final int port;
    private final Map<String, Function<Values, @Nullable CompletableFuture<EventOutcome>>> requests =
            new LinkedHashMap<>();
    private Door door = Door.loopback();
    private @Nullable RequestServer server;

    /**
     * A monitor that does not listen yet.
     *
     * @param name its name in the console, unique within a converter
     * @param port to listen on; 0 for any that is free
     */
    public HttpMonitor(String name, int port) {
        super(name);
        this.port = port;
    }

    /**
     * Also accepts requests from other machines that send the token as {@code Authorization: Bearer TOKEN}.
     *
     * @param host the address to listen on; {@code 0.0.0.0} for all of this machine
     * @param token a secret of at least 16 characters
     * @throws IllegalArgumentException if the token is shorter
     */
    public final HttpMonitor listenOn(String host, String token) {
        door = Door.guarded(host, token);
        return this;
    }

    /**
     * Sets the request that reports that a control of the controller was operated.
     *
     * @param request a method and a path, as in {@code POST /power}
     * @throws IllegalArgumentException if it is something else, or was set before
     */
    public final HttpMonitor controller(String request, String event) {
        controllerRaises(Set.of(event));
        return on(request, values -> pressed(event, values));
    }

    /** Sets the request that reports that the device has done something by itself; see {@link #controller}. */
    public final HttpMonitor device(String request, String event) {
        deviceRaises(Set.of(event));
        return reporting(request, values -> push(fromDevice(event, values)));
    }

    /** Sets the request that reports that the device is in this state of its model; see {@link #controller}. */
    public final HttpMonitor found(String request, String state) {
        return reporting(request, values -> push(foundIn(state)));
    }

    private @Nullable CompletableFuture<EventOutcome> pressed(String event, Values values) {
        try {
            return submit(event, values);
        } catch (UnsupportedOperationException decidedElsewhere) {
            press(event, values);
            return null;
        }
    }

    private HttpMonitor reporting(String request, Consumer<Values> report) {
        return on(request, values -> {
            report.accept(values);
            return null;
        });
    }

    private HttpMonitor on(String request, Function<Values, @Nullable CompletableFuture<EventOutcome>> handler) {
        if (!request.matches("[A-Z]+ /\\S*") || requests.putIfAbsent(request, handler) != null) {
            throw new IllegalArgumentException("'" + request + "' is "
                    + (requests.containsKey(request)
                            ? "there already"
                            : "not a request; write one such as POST /power"));
        }
        return this;
    }

    /**
     * Starts listening.
     *
     * @throws IOException if the port cannot be used; the message says what to do
     */
    public final synchronized HttpMonitor open() throws IOException {
        if (server == null) {
            server = RequestServer.open(door, port, Map.copyOf(requests));
        }
        return this;
    }

    /**
     * The port that it listens on.
     *
     * @throws IllegalStateException if it does not listen
     */
    public final synchronized int port() {
        if (server == null) {
            throw new IllegalStateException(name() + " is not open");
        }
        return server.port();
    }

    /** Frees the port. Idempotent. */
    @Override
    public final synchronized void close() {
        if (server != null) {
            server.close();
        }
    }
}
