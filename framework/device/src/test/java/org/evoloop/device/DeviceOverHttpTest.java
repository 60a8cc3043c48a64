package org.evoloop.device;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** A kettle that has to be asked over HTTP, and a controller that calls this computer. */
@Timeout(60)
class DeviceOverHttpTest {
    private static final String MODELS = """
            ## original

            ```mermaid
            stateDiagram-v2
                [*] --> Off
                Off --> Heating : power
                Heating --> Off : power
                Heating --> Ready : «spontaneous» hot
                Ready --> Off : power
            ```

            ## new

            ```mermaid
            stateDiagram-v2
                [*] --> Off
                Off --> Heating : power
                Heating --> Off : power
                Heating --> Ready : hot
                Ready --> Off : power
                Off --> Tea : tea
                Tea : «device Heating»
                Tea --> Ready : hot
                Tea --> Off : power
            ```
            """;

    private static final String KETTLE = """
            converter: kettle
            models: {original: kettle.md#original, new: kettle.md#new}
            connections:
              kettle: {http: "DEVICE", poll: /state, every: 50 ms, headers: {X-User: me}, header-files: {X-Key: key.txt}}
              buttons: {webhooks: PORT}
            device:
              send: {power: {to: kettle, call: POST /power}}
              state: {from: kettle, json: /state, values: {"off": "Off", heating: Heating, ready: Ready}, infer-events: true}
              readings: {temperature: {from: kettle, json: /temp, unit: °C}}
            controller:
              press: [{from: buttons, values: {POST /tea: tea, POST /power: power}}]
            """;

    @RegisterExtension
    private final TypedConsole console = new TypedConsole();

    private final List<String> called = new CopyOnWriteArrayList<>();
    private volatile String state = "off";

    @TempDir
    private Path folder;

    @BeforeEach
    void draw() throws IOException {
        Files.writeString(folder.resolve("kettle.md"), MODELS);
        Files.writeString(folder.resolve("key.txt"), "abc\n");
    }

    private void answer(HttpExchange exchange) throws IOException {
        if (exchange.getRequestMethod().equals("POST")) {
            called.add(exchange.getRequestURI() + " "
                    + exchange.getRequestHeaders().getFirst("X-User") + " "
                    + exchange.getRequestHeaders().getFirst("X-Key"));
            state = state.equals("off") ? "heating" : "off";
        }
        byte[] body = ("{\"state\":\"" + state + "\",\"temp\":93}").getBytes(StandardCharsets.UTF_8);
        exchange.sendResponseHeaders(200, body.length);
        exchange.getResponseBody().write(body);
        exchange.close();
    }

    @Test
    void aDeviceThatIsPolledAndAControllerThatCalls() throws Exception {
        HttpServer device = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        device.createContext("/", this::answer);
        device.start();
        try {
            int port = freePort();
            Path file = Files.writeString(
                    folder.resolve("kettle.yaml"),
                    KETTLE.replace(
                                    "DEVICE",
                                    "http://127.0.0.1:" + device.getAddress().getPort())
                            .replace("PORT", "" + port));
            CompletableFuture<Integer> status = console.run(file, "--start");
            console.awaitStatus("temperature 93");
            console.awaitStatus("kettle, running");
            call(port, "/tea");
            console.awaitHistory("tea (controller)  (Off, Off) -> (Heating, Tea)");
            assertThat(called).containsExactly("/power me abc");
            state = "ready";
            console.awaitHistory("(Heating, Tea) -> (Ready, Ready)");
            console.exit(status);
        } finally {
            device.stop(0);
        }
    }

    private static int freePort() throws IOException {
        try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            return free.getLocalPort();
        }
    }

    private static void call(int port, String path) throws IOException, InterruptedException {
        HttpRequest request = HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + port + path))
                .POST(HttpRequest.BodyPublishers.noBody())
                .build();
        HttpResponse<String> answer = HttpClient.newHttpClient().send(request, HttpResponse.BodyHandlers.ofString());
        assertThat(answer.statusCode()).isBetween(200, 299);
    }
}
