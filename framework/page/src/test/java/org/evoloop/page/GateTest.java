package org.evoloop.page;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import org.evoloop.console.Console;
import org.evoloop.loop.LoopState;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Who may view and who may operate, byte by byte: a browser sets these headers, which an attacker's page cannot. */
class GateTest {
    private Shown shown;
    private String cookie = "";

    @BeforeEach
    void open() throws IOException {
        shown = new Shown();
    }

    @AfterEach
    void close() {
        shown.close();
    }

    private String own() {
        return "127.0.0.1:" + shown.page.port();
    }

    /** The answer to a request. */
    private String ask(String method, String path, String body, String... headers) throws IOException {
        try (Socket socket = new Socket("127.0.0.1", shown.page.port())) {
            socket.setSoTimeout(20_000);
            byte[] bytes = body.getBytes(StandardCharsets.UTF_8);
            String head = method + " " + path + " HTTP/1.1\r\nConnection: close\r\nContent-Length: " + bytes.length
                    + "\r\n" + String.join("\r\n", headers) + "\r\n\r\n";
            socket.getOutputStream().write(head.getBytes(StandardCharsets.UTF_8));
            socket.getOutputStream().write(bytes);
            return new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    private void admit() throws IOException {
        String answer = ask("POST", "/session", shown.token, "Host: " + own(), "Origin: http://" + own());
        assertThat(answer).startsWith("HTTP/1.1 200").contains("HttpOnly; SameSite=Strict");
        cookie = answer.replaceFirst("(?s).*Set-cookie: ([^;]+);.*", "Cookie: $1");
    }

    @Test
    void theTokenGivesACookieThatAllowsControl() throws IOException {
        admit();
        assertThat(ask("POST", "/command", "start", "Host: " + own(), "Origin: http://" + own(), cookie))
                .startsWith("HTTP/1.1 200")
                .contains("\"status\":0");
        assertThat(shown.converter.status().loop()).isEqualTo(LoopState.RUNNING);
        assertThat(ask("GET", "/controls", "", "Host: " + own(), cookie))
                .contains("\"name\":\"press\"", "\"choices\":[\"Clean\",\"Spot\"]", "\"execute\":[\"Robot2\"]")
                .doesNotContain("is no button", "endSpot");
    }

    @Test
    void othersAreToldTheAddressToLook() throws IOException {
        assertThat(shown.console.page()).contains(URI.create(shown.address() + "/"));
        Console everywhere = new Console(shown.converter, InputStream.nullInputStream(), System.out, System.err);
        try (Page page = Page.open(PageOptions.at("0.0.0.0:0"), everywhere, System.err)) {
            assertThat(everywhere.page())
                    .hasValueSatisfying(address -> assertThat(address.getAuthority())
                            .endsWith(":" + page.port())
                            .doesNotStartWith("0.0.0.0"));
        }
    }

    @Test
    void withoutTheTokenNothingIsDone() throws IOException {
        assertThat(ask("POST", "/command", "start", "Host: " + own(), "Origin: http://" + own()))
                .startsWith("HTTP/1.1 401");
        assertThat(ask("POST", "/session", "guess", "Host: " + own(), "Origin: http://" + own()))
                .startsWith("HTTP/1.1 401");
        assertThat(ask(
                        "POST",
                        "/command",
                        "start",
                        "Host: " + own(),
                        "Origin: http://" + own(),
                        "Cookie: evoloop-" + shown.page.port() + "=" + shown.token))
                .as("the token is not the cookie")
                .startsWith("HTTP/1.1 401");
        assertThat(ask("GET", "/controls", "", "Host: " + own())).startsWith("HTTP/1.1 401");
        assertThat(shown.converter.status().loop()).isNotEqualTo(LoopState.RUNNING);
    }

    @Test
    void anotherSitesPageIsTurnedAwayWithTheCookieToo() throws IOException {
        admit();
        for (String foreign : new String[] {
            "Origin: http://evil.example",
            "Origin: null",
            "Origin: http://127.0.0.1:1",
            "X-No: origin",
            "Origin: https://127.0.0.1"
        }) {
            assertThat(ask("POST", "/command", "start", "Host: " + own(), foreign, cookie))
                    .as(foreign)
                    .startsWith("HTTP/1.1 403");
        }
        assertThat(ask(
                        "POST",
                        "/command",
                        "start",
                        "Host: " + own(),
                        "Origin: http://" + own(),
                        "Sec-Fetch-Site: cross-site",
                        cookie))
                .startsWith("HTTP/1.1 403");
        assertThat(ask("GET", "/events", "", "Host: " + own(), "Sec-Fetch-Site: cross-site"))
                .startsWith("HTTP/1.1 403");
        assertThat(shown.converter.status().loop()).isNotEqualTo(LoopState.RUNNING);
    }

    @Test
    void aTlsProxyInFrontPassesTheControlsOn() throws IOException {
        String host = "Host: localhost";
        String origin = "Origin: https://localhost";
        String answer = ask("POST", "/session", shown.token, host, origin, "Sec-Fetch-Site: same-origin");
        assertThat(answer).startsWith("HTTP/1.1 200");
        cookie = answer.replaceFirst("(?s).*Set-cookie: ([^;]+);.*", "Cookie: $1");
        assertThat(ask("POST", "/command", "start", host, origin, cookie)).startsWith("HTTP/1.1 200");
        assertThat(shown.converter.status().loop()).isEqualTo(LoopState.RUNNING);
    }

    @Test
    void aForeignHostNameThatLeadsHereIsRefused() throws IOException {
        for (String path : new String[] {"/", "/about", "/events", "/history"}) {
            assertThat(ask("GET", path, "", "Host: evil.example"))
                    .as(path)
                    .startsWith("HTTP/1.1 403")
                    .contains("use the address that the program has printed")
                    .doesNotContain("--page");
        }
        assertThat(ask("GET", "/about", "", "Host: localhost:" + shown.page.port()))
                .startsWith("HTTP/1.1 200");
        // Newer JDKs' servers refuse it themselves, with 400.
        assertThat(ask("GET", "/about", "", "X-No: host")).matches("(?s)HTTP/1\\.1 40[03] .*");
    }

    @ParameterizedTest
    @ValueSource(strings = {"exit", "robot x", "history", "status", "help", "", "   ", "\"exit\"", "start\nexit"})
    void thePageHasNoOtherCommands(String line) throws IOException {
        admit();
        ask("POST", "/command", line, "Host: " + own(), "Origin: http://" + own(), cookie);
        assertThat(shown.console.isEnding()).isFalse();
        assertThat(ask("POST", "/command", "x".repeat(5000), "Host: " + own(), "Origin: http://" + own(), cookie))
                .startsWith("HTTP/1.1 413");
    }

    @Test
    void everyAnswerKeepsOthersOutOfThePage() throws IOException {
        assertThat(ask("GET", "/", "", "Host: " + own()))
                .startsWith("HTTP/1.1 200")
                .contains("default-src 'none'", "frame-ancestors 'none'", "nosniff", "no-store");
        assertThat(ask("GET", "/../module-info.class", "", "Host: " + own())).startsWith("HTTP/1.1 404");
        assertThat(ask("DELETE", "/about", "", "Host: " + own(), "Origin: http://" + own()))
                .startsWith("HTTP/1.1 405")
                .contains("Allow: GET");
        for (String path : new String[] {"/", "/about", "/history"}) {
            assertThat(ask("HEAD", path, "", "Host: " + own()))
                    .startsWith("HTTP/1.1 200")
                    .endsWith("\r\n\r\n");
        }
        assertThat(ask("HEAD", "/", "", "Host: evil.example")).startsWith("HTTP/1.1 403");
        assertThat(ask("HEAD", "/session", "", "Host: " + own()))
                .startsWith("HTTP/1.1 405")
                .endsWith("\r\n\r\n");
        assertThat(ask("HEAD", "/events", "", "Host: " + own()))
                .startsWith("HTTP/1.1 405")
                .contains("Allow: GET\r\n");
        assertThat(ask("POST", "/events", "", "Host: " + own(), "Origin: http://" + own()))
                .startsWith("HTTP/1.1 405");
        assertThat(ask("GET", "/events/x", "", "Host: " + own())).startsWith("HTTP/1.1 404");
        assertThat(ask("GET", "/picture?number=9", "", "Host: " + own())).startsWith("HTTP/1.1 404");
        assertThat(ask("GET", "/history?before=x", "", "Host: " + own())).startsWith("HTTP/1.1 200");
    }
}
