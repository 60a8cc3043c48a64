package org.evoloop.models.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.evoloop.studio.Analysis;
import org.evoloop.studio.Studio;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** A studio on a folder with a lamp, and requests to it as its page makes them. */
abstract class StudioRequests {
    static final JsonMapper JSON = new JsonMapper();
    static final String LAMP = """
            # A lamp
            ```mermaid
            ---
            title: original
            ---
            stateDiagram-v2
                [*] --> off
                off --> on : switch
                on --> off : switch
            ```
            ```mermaid
            ---
            title: new
            ---
            stateDiagram-v2
                [*] --> off
                off --> on : switch
                on --> wait : switch
                wait --> off : tm(2s)
                wait --> warm : switch
                warm --> off : switch
            ```
            """;

    @TempDir
    Path folder;

    private Studio studio;
    private final HttpClient http = HttpClient.newHttpClient();
    String origin = "";
    String cookie = "";

    @BeforeEach
    void open() throws Exception {
        Files.writeString(folder.resolve("lamp.md"), LAMP);
        begin(new StudioAnalysis());
    }

    void begin(Analysis analysis) throws IOException, InterruptedException {
        studio = Studio.open(folder, 0, null, analysis);
        String address = studio.address().toString();
        origin = address.replaceFirst("/#.*", "");
        HttpResponse<String> admitted = send("POST", "/session", address.replaceFirst(".*token=", ""), origin);
        cookie = admitted.headers().firstValue("Set-Cookie").orElseThrow().replaceFirst(";.*", "");
    }

    @AfterEach
    void close() {
        studio.close();
    }

    HttpResponse<String> send(String method, String path, String body, String from)
            throws IOException, InterruptedException {
        HttpRequest.Builder request = HttpRequest.newBuilder(URI.create(origin + path))
                .method(method, method.equals("GET") ? BodyPublishers.noBody() : BodyPublishers.ofString(body))
                .header("Cookie", cookie.isEmpty() ? "none=" : cookie);
        if (!method.equals("GET")) {
            request.header("Origin", from);
        }
        return http.send(request.build(), BodyHandlers.ofString());
    }

    JsonNode ask(int status, String method, String path, Object body) throws IOException, InterruptedException {
        HttpResponse<String> answer = send(method, path, JSON.writeValueAsString(body), origin);
        assertThat(answer.statusCode()).as(answer.body()).isEqualTo(status);
        return JSON.readTree(answer.body());
    }

    JsonNode post(String path, Object body) throws IOException, InterruptedException {
        return ask(200, "POST", path, body);
    }

    static Map<String, Object> pair(String... texts) {
        return Map.of(
                "original", Map.of("path", "lamp.md", "name", "original"),
                "new", Map.of("path", "lamp.md", "name", "new"),
                "texts", texts.length == 0 ? Map.of() : Map.of("lamp.md", texts[0]));
    }

    static List<String> all(JsonNode list, String name) {
        return list.valueStream().map(each -> each.path(name).asString("")).toList();
    }
}
