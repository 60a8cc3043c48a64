package org.evoloop.models.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.evoloop.studio.Studio;
import org.evoloop.xmi.ModelFile;
import org.evoloop.xmi.ModelWriter;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.json.JsonMapper;

/** How long the picture and the findings of the largest model take while it is typed; prints both. */
@Tag("slow")
class TypingTest {
    private static final JsonMapper JSON = new JsonMapper();
    private static final int WARM = 25;
    private static final int KEYS = 60;

    @TempDir
    private Path folder;

    @Test
    void thePictureAndTheFindingsOfTheLargestModelKeepUpWithTyping() throws Exception {
        ModelFile roomba = ModelFile.read(Path.of(System.getProperty("evoloop.root"), "models", "roomba.xml"));
        Files.writeString(
                folder.resolve("original.mmd"),
                ModelWriter.MERMAID.write(roomba.find("original").statechart()));
        String home = ModelWriter.MERMAID.write(roomba.find("home").statechart());
        List<Long> pictures = new ArrayList<>();
        List<Long> findings = new ArrayList<>();
        try (Studio studio = Studio.open(folder, 0, null, new StudioAnalysis());
                Page page = new Page(studio)) {
            for (int key = 0; key < WARM + KEYS; key++) {
                // A transition is typed; no picture is one that was there before.
                String text = home + "    Off --> On : e" + key + "x".repeat(key % 12) + "\n";
                Map<String, Object> request = Map.of(
                        "pair",
                        Map.of(
                                "original", Map.of("path", "original.mmd"),
                                "new", Map.of("path", "home.mmd"),
                                "texts", Map.of("home.mmd", text)));
                long drawn = page.post("/api/draw", request);
                long checked = page.post("/api/check", request);
                if (key >= WARM) {
                    pictures.add(drawn);
                    findings.add(checked);
                }
            }
        }
        System.out.println("studio, home: picture p50 " + part(pictures, 50) + " ms, p95 " + part(pictures, 95)
                + " ms; findings p50 " + part(findings, 50) + " ms, p95 " + part(findings, 95) + " ms");
        // Far more than the 150 ms and 500 ms of a quiet machine with 2 cores, since this one may be busy.
        assertThat(part(pictures, 50)).isLessThan(1_000);
        assertThat(part(findings, 50)).isLessThan(2_000);
    }

    private static long part(List<Long> nanos, int percent) {
        List<Long> sorted = nanos.stream().sorted().toList();
        return sorted.get(Math.min(sorted.size() - 1, sorted.size() * percent / 100)) / 1_000_000;
    }

    /** A page in the browser. */
    private static final class Page implements AutoCloseable {
        private final HttpClient http = HttpClient.newHttpClient();
        private final String origin;
        private final String cookie;

        Page(Studio studio) throws IOException, InterruptedException {
            String address = studio.address().toString();
            origin = address.replaceFirst("/#.*", "");
            cookie = http.send(
                            request("/session", address.replaceFirst(".*token=", ""))
                                    .build(),
                            BodyHandlers.discarding())
                    .headers()
                    .firstValue("Set-Cookie")
                    .orElseThrow()
                    .replaceFirst(";.*", "");
        }

        private HttpRequest.Builder request(String path, String body) {
            return HttpRequest.newBuilder(URI.create(origin + path))
                    .header("Origin", origin)
                    .POST(BodyPublishers.ofString(body));
        }

        long post(String path, Map<String, Object> body) throws IOException, InterruptedException {
            HttpRequest request = request(path, JSON.writeValueAsString(body))
                    .header("Cookie", cookie)
                    .build();
            long begun = System.nanoTime();
            assertThat(http.send(request, BodyHandlers.ofString()).statusCode()).isEqualTo(200);
            return System.nanoTime() - begun;
        }

        @Override
        public void close() {}
    }
}
