package org.evoloop.http;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.evoloop.converter.PushMonitor;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A device behind a real socket that obeys, refuses, hangs, hangs up, or sends an endless answer. */
@Timeout(120)
class HttpExecuteTest {
    private static final String HANG_UP = "";
    private static final String HANG = "hang";

    private final PushMonitor wall = new PushMonitor("Wall");
    private final List<String> heard = new CopyOnWriteArrayList<>();
    private final List<Socket> open = new CopyOnWriteArrayList<>();
    private ServerSocket device;
    private volatile String toggled = "200 OK";
    private volatile String state = "off";
    private volatile @Nullable String raw;

    @BeforeEach
    void listen() throws IOException {
        device = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
        Threads.start("device", () -> {
            try {
                while (true) {
                    Socket client = device.accept();
                    open.add(client);
                    Threads.start("device-client", () -> serve(client));
                }
            } catch (IOException closed) {
                // The test is over.
            }
        });
    }

    @AfterEach
    void close() throws IOException {
        device.close();
        for (Socket socket : open) {
            socket.close();
        }
    }

    private void serve(Socket client) {
        try (client) {
            BufferedReader lines =
                    new BufferedReader(new InputStreamReader(client.getInputStream(), StandardCharsets.UTF_8));
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                if (line.contains(" HTTP/1.1")) {
                    heard.add(line.replace(" HTTP/1.1", ""));
                } else if (line.isEmpty() && !answer(client)) {
                    return;
                }
            }
        } catch (IOException gone) {
            // The client has closed the connection.
        }
    }

    private boolean answer(Socket client) throws IOException {
        if (raw != null) {
            client.getOutputStream().write(raw.getBytes(StandardCharsets.UTF_8));
            return false;
        }
        boolean asked = heard.get(heard.size() - 1).endsWith("/state");
        String status = asked ? "200 OK" : toggled;
        if (status.equals(HANG_UP)) {
            return false;
        }
        if (!status.equals(HANG)) {
            String body = asked ? state : "done";
            client.getOutputStream()
                    .write(("HTTP/1.1 " + status + "\r\nContent-Length: " + body.length() + "\r\n\r\n" + body)
                            .getBytes(StandardCharsets.UTF_8));
        }
        return true;
    }

    private String address(String path) {
        return "http://127.0.0.1:" + device.getLocalPort() + path;
    }

    private HttpExecute lamp(HttpCall call, Duration limit) {
        return new HttpExecute("Lamp", Map.of("switch", call), limit);
    }

    @Test
    void aStepIsARequest() throws Exception {
        HttpExecute execute = lamp(HttpCall.get(address("/toggle?now=1")), Lamp.PATIENCE);
        try (Lamp lamp = new Lamp(wall, execute)) {
            wall.press("switch");
            lamp.awaitState("on");
            assertThat(heard).containsExactly("GET /toggle?now=1");
            assertThat(execute.isUp()).isTrue();
            assertThat(execute.describe())
                    .matches(address("") + " reached at \\d{4}-\\d\\d-\\d\\d \\d\\d:\\d\\d:\\d\\d");
        }
    }

    @Test
    void whatTheDeviceRefusesHasFailed() throws Exception {
        toggled = "503 Busy";
        HttpExecute execute = lamp(HttpCall.post(address("/toggle"), "").header("X-Who", "me"), Lamp.PATIENCE);
        try (Lamp lamp = new Lamp(wall, execute)) {
            wall.press("switch");
            lamp.awaitHistory(
                    "POST http://127.0.0.1:" + device.getLocalPort() + "/toggle was answered with status 503");
            lamp.awaitState("off");
            assertThat(execute.isUp()).isFalse();
            assertThat(execute.downSince()).isPresent();
            toggled = "302 Found";
            wall.press("switch");
            lamp.awaitHistory("use the address that it redirects to");
            assertThat(heard).hasSize(2);
        }
    }

    @Test
    void anotherStatusCanMeanThatItObeys() throws Exception {
        HttpExecute execute = lamp(HttpCall.post(address("/toggle"), "").accepting(300, 302), Lamp.PATIENCE);
        try (Lamp lamp = new Lamp(wall, execute)) {
            toggled = "200 OK";
            wall.press("switch");
            lamp.awaitHistory("was answered with status 200");
            lamp.awaitState("off");
            toggled = "302 Found";
            wall.press("switch");
            lamp.awaitState("on");
        }
        assertThatThrownBy(() -> HttpCall.get("http://lamp").accepting(300, 200))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("from 300 to 200");
    }

    @Test
    void aDeviceThatIsNotThereIsNamed() throws Exception {
        device.close();
        try (Lamp lamp = new Lamp(wall, lamp(HttpCall.get(address("/toggle")), Lamp.PATIENCE))) {
            wall.press("switch");
            lamp.awaitHistory("check that it is switched on, and the address");
        }
    }

    @Test
    void whatMayHaveArrivedIsNotSentAgain() throws Exception {
        toggled = HANG_UP;
        try (Lamp lamp = new Lamp(wall, lamp(HttpCall.get(address("/toggle")), Lamp.PATIENCE))) {
            wall.press("switch");
            lamp.awaitHistory("whether it has arrived is not known");
            assertThat(heard).containsExactly("GET /toggle");
        }
        heard.clear();
        toggled = HANG;
        try (Lamp lamp = new Lamp(wall, lamp(HttpCall.post(address("/toggle"), ""), Duration.ofSeconds(1)))) {
            wall.press("switch");
            lamp.awaitHistory("was not answered within 1000 ms");
            // The device may read it later.
            await().atMost(Lamp.PATIENCE).untilAsserted(() -> assertThat(heard).containsExactly("POST /toggle"));
        }
    }

    @Test
    void whatCanBeRepeatedIsSentAgain() throws Exception {
        toggled = HANG_UP;
        HttpCall on = HttpCall.put(address("/on"), "").canBeRepeated();
        try (Lamp lamp = new Lamp(wall, lamp(on, Lamp.PATIENCE))) {
            wall.press("switch");
            lamp.awaitHistory("whether it has arrived is not known");
            assertThat(heard).containsExactly("PUT /on", "PUT /on", "PUT /on");
        }
    }

    @Test
    void aDeviceThatCanBeAskedIsAskedInsteadWhereItIs() throws Exception {
        toggled = HANG_UP;
        state = "{\"light\":\"on\"}";
        HttpExecute execute = lamp(HttpCall.get(address("/toggle")), Lamp.PATIENCE)
                .asking(HttpCall.get(address("/state")), answer -> answer.contains("\"on\"") ? "on" : "off");
        try (Lamp lamp = new Lamp(wall, execute)) {
            wall.press("switch");
            lamp.awaitState("on");
            assertThat(heard).containsOnlyOnce("GET /toggle").containsSubsequence("GET /toggle", "GET /state");
        }
    }

    @Test
    void aDeviceThatWasNeverThereIsNotSaidToAnswer() throws Exception {
        device.close();
        HttpExecute execute = lamp(HttpCall.get(address("/toggle")), Lamp.PATIENCE);
        assertThat(execute.isUp()).isFalse();
        assertThat(execute.describe()).isEqualTo(address("") + " has not been reached yet");
        try (Lamp lamp = new Lamp(wall, execute)) {
            await().atMost(Lamp.PATIENCE).until(() -> execute.describe().contains("the device cannot be reached"));
            assertThat(execute.isUp()).isFalse();
            lamp.awaitState("off");
        }
    }

    @Test
    void aDeviceThatGoesAndComesBackIsNoticedWithoutAnEvent() throws Exception {
        HttpExecute execute =
                lamp(HttpCall.get(address("/toggle")), Lamp.PATIENCE).watch(Duration.ofMillis(20));
        try (Lamp lamp = new Lamp(wall, execute)) {
            await().atMost(Lamp.PATIENCE).until(execute::isUp);
            int port = device.getLocalPort();
            device.close();
            await().atMost(Lamp.PATIENCE).until(() -> !execute.isUp());
            assertThat(execute.downSince()).isPresent();
            assertThat(execute.describe()).contains("the device cannot be reached");
            device = new ServerSocket(port, 50, InetAddress.getLoopbackAddress());
            await().atMost(Lamp.PATIENCE).until(execute::isUp);
            assertThat(execute.downSince()).isEmpty();
            lamp.awaitState("off");
            assertThat(heard)
                    .as("nothing is asked of a device without a question")
                    .isEmpty();
        }
    }

    @Test
    void aDeviceThatTakesConnectionsButDoesNotAnswerIsNoticedByTheQuestion() throws Exception {
        toggled = HANG;
        HttpExecute execute = lamp(HttpCall.get(address("/toggle")), Duration.ofMillis(200))
                .asking(HttpCall.get(address("/hung")), answer -> "off")
                .watch(Duration.ofMillis(20));
        try (Lamp lamp = new Lamp(wall, execute)) {
            await().atMost(Lamp.PATIENCE).until(() -> execute.describe().contains("was not answered within 200 ms"));
            assertThat(execute.isUp()).isFalse();
            lamp.awaitState("off");
        }
        await("the checks end with the converter")
                .atMost(Lamp.PATIENCE)
                .untilAsserted(() -> assertThat(Thread.getAllStackTraces().keySet())
                        .extracting(Thread::getName)
                        .doesNotContain("http-Lamp"));
    }

    private String body(String answer) throws IOException, InterruptedException {
        raw = answer;
        return new Caller(Lamp.PATIENCE).call(HttpCall.get(address("")), ReceivedReply::body);
    }

    @Test
    void answersOfAllFormsAreRead() throws Exception {
        assertThat(body("HTTP/1.1 200 OK\r\nContent-Length: 4\r\n\r\nlonger")).isEqualTo("long");
        assertThat(body("HTTP/1.0 200 OK\n\nto the end")).isEqualTo("to the end");
        assertThat(body("HTTP/1.1 100 Continue\r\n\r\nHTTP/1.1 201 Made\r\nTransfer-Encoding: chunked\r\n\r\n"
                        + "5;x=y\r\nhello\r\n1\r\n!\r\n0\r\n\r\n"))
                .isEqualTo("hello!");
        assertThat(body("HTTP/1.1 200 OK\r\n\r\n" + "x".repeat(1_000_000))).hasSize(ReceivedReply.LONGEST_BODY);
        assertThat(body("HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\nF4240\r\n" + "x".repeat(1_000_000)))
                .hasSize(ReceivedReply.LONGEST_BODY);
        assertThat(heard).hasSize(5).containsOnly("GET /");
    }

    @Test
    void aTruncatedOrNonHttpAnswerIsNotAnAnswer() {
        for (String nonsense : List.of(
                "SSH-2.0\r\n",
                "",
                "HTTP/1.1 200",
                "HTTP/1.1 200 OK\r\nContent-Length: 40\r\n\r\nshort",
                "HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n5\r\nhe",
                "HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\nzz\r\n",
                "HTTP/1.1 200 OK\r\n" + "x".repeat(100_000),
                "HTTP/1.1 200 OK\r\n" + "a: b\r\n".repeat(1_000))) {
            assertThatThrownBy(() -> body(nonsense)).isInstanceOf(UnansweredException.class);
        }
    }

    @Test
    void aDeviceWithoutTheTlsThatIsWantedIsNotReached() {
        assertThatThrownBy(() -> new Caller(Duration.ofSeconds(5))
                        .call(HttpCall.get(address("").replace("http:", "https:")), ReceivedReply::body))
                .isNotInstanceOf(UnansweredException.class)
                .hasMessageContaining("cannot be sent: the device cannot be reached");
    }

    @Test
    void whatIsNoRequestIsRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> HttpCall.get("lamp.local/toggle"))
                .withMessage("'lamp.local/toggle' is not an address; write one such as http://lamp.local/toggle");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> HttpCall.get("http://lamp/").header("Host", "other"));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> lamp(HttpCall.get("http://lamp/"), Duration.ZERO))
                .withMessageContaining("give more than 0");
        assertThat(HttpCall.post("https://user:secret@lamp/on?key=secret", "")).hasToString("POST https://lamp/on");
    }
}
