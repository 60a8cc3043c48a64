package org.evoloop.device;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.evoloop.imitation.Imitation;

/**
 * A server with those requests of OctoPrint's REST API that are used: {@code POST /api/job}, {@code POST /api/printer/bed}, and
 * {@code GET /api/printer}. A lost request is never answered; the bed has its target at once.
 */
final class OctoPrintImitation implements AutoCloseable {
    static final String KEY = "s3cr3tKey";
    private static final String ROOM = "21.3";
    private static final Map<String, String> TEXTS =
            Map.of("Ready", "Operational", "Printing", "Printing", "Paused", "Paused");

    private final Imitation device;
    private final HttpServer server;
    private final ExecutorService threads = Executors.newCachedThreadPool();

    private volatile String bed = ROOM;

    OctoPrintImitation(Imitation device) throws IOException {
        this.device = device;
        server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        server.setExecutor(threads);
        server.createContext("/", this::hear);
        server.start();
    }

    String address() {
        return "http://127.0.0.1:" + server.getAddress().getPort();
    }

    private void hear(HttpExchange request) throws IOException {
        String body = new String(request.getRequestBody().readAllBytes(), StandardCharsets.UTF_8);
        String asked =
                request.getRequestMethod() + " " + request.getRequestURI().getPath();
        if (!KEY.equals(request.getRequestHeaders().getFirst("X-Api-Key"))) {
            answer(request, 403, "{}");
            return;
        }
        switch (asked) {
            case "GET /api/printer" ->
                answer(
                        request,
                        200,
                        "{\"state\":{\"text\":\"" + TEXTS.get(device.truth())
                                + "\"},\"temperature\":{\"bed\":{\"actual\":" + bed + "},\"tool0\":{\"actual\":" + ROOM
                                + "}}}");
            case "POST /api/printer/bed" -> {
                bed = body.contains(":0}") ? ROOM : body.replaceFirst(".*\"target\":([0-9]+).*", "$1");
                answer(request, 204, "");
            }
            case "POST /api/job" ->
                device.take(
                        body.replaceFirst(".*\"(?:action|command)\":\"([a-z]+)\"}$", "$1"),
                        () -> answer(request, 204, ""));
            default -> answer(request, 404, "{}");
        }
    }

    private static void answer(HttpExchange request, int status, String body) {
        try (request) {
            byte[] bytes = body.getBytes(StandardCharsets.UTF_8);
            request.sendResponseHeaders(status, bytes.length == 0 ? -1 : bytes.length);
            request.getResponseBody().write(bytes);
        } catch (IOException gone) {
            // The client has given up.
        }
    }

    @Override
    public void close() {
        device.close();
        server.stop(0);
        threads.shutdownNow();
    }
}
