package org.evoloop.models.studio;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.evoloop.studio.Studio;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Whatever the page asks, it is answered or refused, and the folder keeps its files. CONTRIBUTING.md says how to let Jazzer
 * search for more.
 */
@Timeout(60)
class StudioFuzzTest {
    private static final List<String> PATHS = List.of(
            "/api/draw",
            "/api/check",
            "/api/plan",
            "/api/edit",
            "/api/try",
            "/api/scenario",
            "/api/property",
            "/api/device",
            "/api/converters/nobody");
    private static final HttpClient HTTP = HttpClient.newHttpClient();
    private static final Path FOLDER;
    private static final Studio STUDIO;
    private static final String ORIGIN;
    private static final String COOKIE;

    static {
        try {
            FOLDER = Files.createTempDirectory("studio-fuzz");
            Files.writeString(FOLDER.resolve("a.mmd"), "stateDiagram-v2\n[*] --> A\nA --> B : e\n");
            STUDIO = Studio.open(FOLDER, 0, null, new StudioAnalysis());
            String address = STUDIO.address().toString();
            ORIGIN = address.replaceFirst("/#.*", "");
            HttpResponse<Void> admitted = HTTP.send(
                    HttpRequest.newBuilder(URI.create(ORIGIN + "/session"))
                            .header("Origin", ORIGIN)
                            .POST(BodyPublishers.ofString(address.replaceFirst(".*token=", "")))
                            .build(),
                    BodyHandlers.discarding());
            COOKIE = admitted.headers().firstValue("Set-Cookie").orElseThrow().replaceFirst(";.*", "");
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        } catch (InterruptedException interrupted) {
            throw new IllegalStateException(interrupted);
        }
    }

    @AfterAll
    static void close() {
        STUDIO.close();
    }

    /** The first byte chooses what is asked for. */
    @MethodSource("seeds")
    @FuzzTest
    void aRequestOfAnyBytesIsAnswered(byte[] bytes) throws IOException, InterruptedException {
        if (bytes.length == 0) {
            return;
        }
        String path = PATHS.get(Math.floorMod(bytes[0], PATHS.size()));
        HttpResponse<String> answer = HTTP.send(
                HttpRequest.newBuilder(URI.create(ORIGIN + path))
                        .header("Origin", ORIGIN)
                        .header("Cookie", COOKIE)
                        .POST(BodyPublishers.ofByteArray(bytes, 1, bytes.length - 1))
                        .build(),
                BodyHandlers.ofString());
        assertThat(answer.statusCode()).as(answer.body()).isIn(200, 400, 403, 404, 422);
        assertThat(answer.body()).startsWith("{");
        assertThat(FOLDER.toFile().list()).containsExactly("a.mmd");
    }

    static List<byte[]> seeds() {
        String pair = "\"pair\":{\"original\":{\"path\":\"a.mmd\"},\"new\":{\"path\":\"b.mmd\"},\"texts\":{\"b.mmd\":"
                + "\"stateDiagram-v2\\n[*] --> A\\nA --> B : e\\nB --> C : after 2 s [g] / f\\nstate C {\\n[*] --> D\\n}\"}}";
        String edit =
                "{\"path\":\"b.mmd\",\"text\":\"stateDiagram-v2\\n[*] --> A\\n\",\"edit\":{\"kind\":\"add-transition\","
                        + "\"source\":\"A\",\"target\":\"A\",\"event\":\"e\",\"line\":2}}";
        List<String> bodies = List.of(
                "{" + pair + ",\"view\":\"around\",\"around\":\"B\"}",
                "{" + pair + ",\"properties\":\"a: always can B\"}",
                "{" + pair + ",\"state\":\"A\",\"event\":\"e\"}",
                edit,
                "{" + pair + ",\"run\":[{\"press\":\"e\"},{\"guard\":\"g\",\"value\":true},{\"after\":\"2 s\"}]}",
                "{" + pair + ",\"title\":\"t\",\"run\":[{\"press\":\"e\"},{\"device\":\"e\"}]}",
                "{" + pair + ",\"property\":\"always can B\"}",
                "{\"path\":\"a.yaml\",\"text\":\"converter: x\\n\"}",
                "{\"command\":\"evolve\",\"new\":\"a.mmd#x\",\"probation\":9}");
        return IntStream.range(0, bodies.size())
                .mapToObj(i -> {
                    byte[] body = bodies.get(i).getBytes(StandardCharsets.UTF_8);
                    byte[] seed = Arrays.copyOf(new byte[] {(byte) i}, body.length + 1);
                    System.arraycopy(body, 0, seed, 1, body.length);
                    return seed;
                })
                .toList();
    }
}
