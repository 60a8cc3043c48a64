package org.evoloop.homeassistant;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import org.evoloop.Logged;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What is said of an address where no Home Assistant is, and of what an entity never says. */
@Timeout(120)
class HomeTroubleTest {
    private static final Duration LIMIT = Duration.ofSeconds(40);

    private static void assertTrouble(String url, String text) {
        try (HomeConnection connection = new HomeConnection(HomeAddress.parse(url), () -> "a token")) {
            connection.open();
            await().atMost(LIMIT)
                    .untilAsserted(() -> assertThat(connection.describe()).contains(text));
        }
    }

    @Test
    void whereNothingListensThatIsSaid() throws IOException {
        int port;
        try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            port = free.getLocalPort();
        }
        assertTrouble("http://127.0.0.1:" + port, "nothing listens there; check the address");
    }

    @Test
    void anUnknownNameIsSaid() {
        assertTrouble("http://nowhere.invalid", "there is no computer of this name");
    }

    /** A server that answers whatever comes with these bytes. */
    private static void assertTroubleWith(String answer, String scheme, String text) throws Exception {
        try (ServerSocket other = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            Thread answering = new Thread(() -> {
                while (!other.isClosed()) {
                    try (Socket client = other.accept()) {
                        client.getOutputStream().write(answer.getBytes(StandardCharsets.US_ASCII));
                    } catch (IOException closed) {
                        return;
                    }
                }
            });
            answering.start();
            assertTrouble(scheme + "://127.0.0.1:" + other.getLocalPort(), text);
            other.close();
            answering.join();
        }
    }

    @Test
    void withoutTlsThatIsSaid() throws Exception {
        assertTroubleWith(
                "HTTP/1.1 400 Bad Request\r\n\r\n", "https", "it does not speak TLS there; begin the URL with http://");
    }

    @Test
    void anotherProgramIsSaid() throws Exception {
        assertTroubleWith("220 smtp ready\r\n", "http", "what answers there does not speak http://");
    }

    @Test
    void whatAnEntityNeverSaysIsANoteWithItsPlace() throws Exception {
        try (HomeImitation home = new HomeImitation();
                Logged logged = new Logged("org.evoloop.homeassistant");
                HomeConnection connection =
                        new HomeConnection(HomeAddress.parse(home.url()), () -> HomeImitation.TOKEN)) {
            home.put("light.lamp", "on", "{\"brightness\":7}");
            home.put("event.remote", "unknown", "{\"event_type\":null,\"event_types\":[\"single\",\"double\"]}");
            home.put("select.program", "eco", "{\"options\":[\"eco\",\"fast\"]}");
            connection
                    .expect(EntityValue.attribute("light.lamp", "brightnes"))
                    .expect(EntityValue.attribute("light.lamp", "brightness"))
                    .expect(EntityValue.attribute("event.remote", "event_type"), "single", "dubble")
                    .expect(EntityValue.state("select.program"), "eco", "quick")
                    .placed("light.lamp's brightnes", "lamp.yaml:7")
                    .open();
            await().atMost(LIMIT).until(connection::isUp);
            assertThat(logged.lines())
                    .anyMatch(line -> line.contains(
                            "lamp.yaml:7: light.lamp has no attribute brightnes now; did you mean brightness?"))
                    .anyMatch(
                            line -> line.contains("event.remote's event_type is never 'dubble'; did you mean double?"))
                    .anyMatch(line -> line.contains("select.program is never 'quick'; there is eco, fast"))
                    .noneMatch(line -> line.contains("has no attribute brightness"));
        }
    }
}
