package org.evoloop.benchmarks.studio;

import java.io.IOException;
import java.net.HttpURLConnection;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.util.Map;
import tools.jackson.databind.json.JsonMapper;

/** Asks the studio what its page asks for after each key. */
final class TypingPage {
    private static final JsonMapper JSON = new JsonMapper();

    private final HttpClient http = HttpClient.newHttpClient();
    private final String origin;
    private final String cookie;

    /** @param address as the studio prints it, with the token */
    TypingPage(String address) throws IOException, InterruptedException {
        origin = address.replaceFirst("/#.*", "");
        cookie = send("/session", address.replaceFirst(".*token=", ""), "none=")
                .headers()
                .firstValue("Set-Cookie")
                .orElseThrow()
                .replaceFirst(";.*", "");
    }

    /** Sends a pair, of which the new model is {@code text}; how many milliseconds the answer takes. */
    double ask(String path, String text) throws IOException, InterruptedException {
        String request = JSON.writeValueAsString(Map.of(
                "pair",
                Map.of(
                        "original", Map.of("path", "original.mmd"),
                        "new", Map.of("path", "home.mmd"),
                        "texts", Map.of("home.mmd", text))));
        long begun = System.nanoTime();
        send(path, request, cookie);
        return (System.nanoTime() - begun) / 1e6;
    }

    private HttpResponse<String> send(String path, String body, String sent) throws IOException, InterruptedException {
        HttpRequest request = HttpRequest.newBuilder(URI.create(origin + path))
                .header("Origin", origin)
                .header("Cookie", sent)
                .POST(BodyPublishers.ofString(body))
                .build();
        HttpResponse<String> answer = http.send(request, BodyHandlers.ofString());
        if (answer.statusCode() != HttpURLConnection.HTTP_OK) {
            throw new IOException(path + ": " + answer.statusCode() + " " + answer.body());
        }
        return answer;
    }
}
