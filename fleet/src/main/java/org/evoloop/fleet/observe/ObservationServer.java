package org.evoloop.fleet.observe;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import io.micrometer.core.instrument.binder.MeterBinder;
import io.micrometer.core.instrument.binder.jvm.JvmMemoryMetrics;
import io.micrometer.core.instrument.binder.jvm.JvmThreadMetrics;
import io.micrometer.core.instrument.binder.system.ProcessorMetrics;
import io.micrometer.prometheusmetrics.PrometheusConfig;
import io.micrometer.prometheusmetrics.PrometheusMeterRegistry;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Properties;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.time.Clock;
import org.evoloop.time.RequestThreads;
import org.evoloop.time.SystemClock;

/**
 * Serves {@code /metrics} for Prometheus, and {@code /health}: status 200 if the program does its work, 503 if not, with
 * the reason as text.
 *
 * <p>Threading: thread-safe. Each request has a thread while it is answered.
 *
 * @since 0.1
 */
public final class ObservationServer implements AutoCloseable {
    private static final Pattern ADDRESS = Pattern.compile("(?:(\\[[0-9a-fA-F:.]+]|[A-Za-z0-9.-]+):)?([0-9]{1,5})");
    private static final int HIGHEST_PORT = 65_535;
    private static final String LOOPBACK = "127.0.0.1";
    private static final int MOST_REQUESTS = 8;
    private static final Duration REQUEST_LIMIT = Duration.ofSeconds(10);
    private static final int OK = 200;
    private static final int NOT_FOUND = 404;
    private static final int ONLY_GET = 405;
    private static final int UNAVAILABLE = 503;

    private final PrometheusMeterRegistry registry = new PrometheusMeterRegistry(PrometheusConfig.DEFAULT);
    private final Clock clock = new SystemClock();
    private final RequestThreads threads =
            new RequestThreads("evoloop-observation", MOST_REQUESTS, REQUEST_LIMIT, clock);
    private final HttpServer server;
    private final Supplier<Health> health;

    private ObservationServer(HttpServer server, MeterBinder metrics, Supplier<Health> health) {
        this.server = server;
        this.health = health;
        new JvmMemoryMetrics().bindTo(registry);
        new JvmThreadMetrics().bindTo(registry);
        new ProcessorMetrics().bindTo(registry);
        metrics.bindTo(registry);
        server.setExecutor(threads);
        server.createContext("/", this::handle);
        server.start();
    }

    /**
     * Opens it.
     *
     * @param address {@code PORT}, for this machine only, or {@code HOST:PORT}; port 0 is any that is free
     * @param metrics of the program; memory, threads and processor time are added
     * @param health must not wait
     * @throws IllegalArgumentException if the address cannot be used
     */
    public static ObservationServer open(String address, MeterBinder metrics, Supplier<Health> health) {
        Matcher parts = ADDRESS.matcher(address);
        if (!parts.matches() || Integer.parseInt(parts.group(2)) > HIGHEST_PORT) {
            throw new IllegalArgumentException("--metrics takes a port, 0 to " + HIGHEST_PORT
                    + ", and before it a host if others than this machine shall see it, as in 9090 or 192.168.1.5:9090;"
                    + " not '" + address + "'");
        }
        String host = parts.group(1) == null ? LOOPBACK : parts.group(1);
        Properties settings = System.getProperties();
        // The JDK's server reads these once. It closes connections that send no request, and takes no more than these.
        settings.putIfAbsent("sun.net.httpserver.nodelay", "true");
        settings.putIfAbsent("sun.net.httpserver.idleInterval", Long.toString(REQUEST_LIMIT.toSeconds()));
        settings.putIfAbsent("sun.net.httpserver.clockTick", "1000");
        settings.putIfAbsent("jdk.httpserver.maxConnections", "64");
        try {
            InetSocketAddress at = new InetSocketAddress(InetAddress.getByName(host), Integer.parseInt(parts.group(2)));
            return new ObservationServer(HttpServer.create(at, 0), metrics, health);
        } catch (IOException unusable) {
            throw new IllegalArgumentException(
                    "--metrics: " + address + " cannot be used (" + unusable.getMessage()
                            + "); choose another port, or 0 for any that is free",
                    unusable);
        }
    }

    /** Its address, as {@code http://HOST:PORT}. */
    public String url() {
        InetSocketAddress at = server.getAddress();
        String host = at.getAddress().getHostAddress();
        return "http://" + (host.contains(":") ? "[" + host + "]" : host) + ":" + at.getPort();
    }

    private void handle(HttpExchange exchange) throws IOException {
        try (exchange) {
            switch (exchange.getRequestURI().getPath()) {
                case "/metrics" -> answer(exchange, OK, "text/plain; version=0.0.4", registry.scrape());
                case "/health" -> {
                    Health now = health.get();
                    answer(exchange, now.isGood() ? OK : UNAVAILABLE, "text/plain", now.detail() + "\n");
                }
                default -> answer(exchange, NOT_FOUND, "text/plain", "there are /metrics and /health\n");
            }
        }
    }

    private static void answer(HttpExchange exchange, int status, String type, String text) throws IOException {
        boolean reads = exchange.getRequestMethod().equals("GET");
        boolean asksOnly = exchange.getRequestMethod().equals("HEAD");
        byte[] body = (reads || asksOnly ? text : "only GET is understood\n").getBytes(StandardCharsets.UTF_8);
        exchange.getResponseHeaders().set("Content-Type", type + "; charset=utf-8");
        exchange.sendResponseHeaders(reads || asksOnly ? status : ONLY_GET, asksOnly ? -1 : body.length);
        if (!asksOnly) {
            exchange.getResponseBody().write(body);
        }
    }

    /** Frees the port. Idempotent. */
    @Override
    public void close() {
        server.stop(0);
        threads.close();
        registry.close();
        clock.close();
    }
}
