package org.evoloop.http;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.awaitility.Awaitility;
import org.evoloop.HalfRequests;
import org.evoloop.converter.EventExecute;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.slf4j.LoggerFactory;

/** Requests of a real client, and of misbehaving ones. */
@Timeout(120)
class HttpMonitorTest {
    private static final String TOKEN = "0123456789abcdef";

    private final BlockingQueue<Values> sent = new LinkedBlockingQueue<>();
    private final HttpMonitor monitor = new HttpMonitor("Buttons", 0);
    private final HttpClient client = HttpClient.newHttpClient();
    private Lamp lamp;
    private volatile boolean noCurrent;

    @BeforeEach
    void open() throws IOException {
        monitor.controller("POST /switch", "switch")
                .controller("GET /switch", "switch")
                .device("POST /by-hand", "switch")
                .found("POST /is-off", "off")
                .open();
        lamp = new Lamp(monitor, new EventExecute("Bulb") {
            @Override
            protected Set<String> sendableEvents() {
                return Set.of("switch");
            }

            @Override
            protected void send(Step step) {
                if (noCurrent) {
                    throw new IllegalStateException("no current");
                }
                sent.add(values());
            }
        });
    }

    @AfterEach
    void close() {
        monitor.close();
        lamp.close();
    }

    private HttpRequest.Builder to(String path) {
        return HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + monitor.port() + path));
    }

    private static HttpRequest.BodyPublisher body(String text) {
        return HttpRequest.BodyPublishers.ofString(text);
    }

    private int status(HttpRequest.Builder request) throws Exception {
        return client.send(request.build(), HttpResponse.BodyHandlers.discarding())
                .statusCode();
    }

    private String answer(HttpRequest.Builder request) throws Exception {
        HttpResponse<String> answer = client.send(request.build(), HttpResponse.BodyHandlers.ofString());
        return answer.statusCode() + " " + answer.body().strip();
    }

    private void sendChunk(String chunk) throws IOException {
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), monitor.port())) {
            socket.setSoTimeout(20_000);
            socket.getOutputStream()
                    .write(("POST /switch HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\n" + chunk)
                            .getBytes(StandardCharsets.US_ASCII));
            socket.shutdownOutput();
            socket.getInputStream().readAllBytes();
        } catch (SocketException hungUp) {
            // The server may close the connection.
        }
    }

    @Test
    void aMalformedRequestIsLoggedOnceAtMostAndWithoutATrace() throws Exception {
        Logger log = (Logger) LoggerFactory.getLogger(HttpMonitor.class);
        ListAppender<ILoggingEvent> logged = new ListAppender<>();
        logged.start();
        log.setLevel(Level.DEBUG);
        log.addAppender(logged);
        try {
            for (String chunk : List.of("FFFFFFFF\r\n", "zz\r\n\r\n", "2\r\nokay\r\n", "-5\r\n")) {
                sendChunk(chunk);
            }
            assertThat(status(to("/switch").POST(body("")))).isEqualTo(200);
        } finally {
            log.detachAppender(logged);
            log.setLevel(null);
        }
        assertThat(logged.list)
                .filteredOn(event -> event.getLevel() != Level.DEBUG && event.getThrowableProxy() != null)
                .isEmpty();
        // Some JDKs' servers report all of these as broken connections.
        assertThat(logged.list)
                .filteredOn(event -> event.getLevel() == Level.WARN)
                .extracting(ILoggingEvent::getFormattedMessage)
                .hasSizeLessThan(2)
                .allSatisfy(message -> assertThat(message)
                        .startsWith("a client's request POST /switch is malformed: ")
                        .hasSizeLessThan(300));
    }

    @ParameterizedTest
    @ValueSource(strings = {"NaN", "Infinity", "-Infinity", "0x1p3", "1d", "1e999", "1e3", ".5", "1."})
    void whatIsNoPlainNumberIsText(String text) throws Exception {
        assertThat(status(to("/switch?value=" + text).POST(body("")))).isEqualTo(200);
        assertThat(sent.poll(20, TimeUnit.SECONDS)).isEqualTo(Values.of("value", text));
    }

    @Test
    void aRequestIsAnEventWithValues() throws Exception {
        assertThat(status(to("/switch?warm=21.5&room=the%20kitchen").POST(body("hällo"))))
                .isEqualTo(200);
        assertThat(sent.poll(20, TimeUnit.SECONDS))
                .isEqualTo(Values.of("warm", 21.5).with("room", "the kitchen").with("body", "hällo"));
        lamp.awaitState("on");
        assertThat(status(to("/is-off").POST(body("")))).isEqualTo(204);
        lamp.awaitState("off");
        assertThat(status(to("/by-hand").POST(body("")))).isEqualTo(204);
        lamp.awaitState("on");
        assertThat(sent).isEmpty();
    }

    @Test
    void aBadRequestIsAnsweredWithItsError() throws Exception {
        assertThat(answer(to("/nonsense")))
                .isEqualTo("404 known are: GET /switch, POST /by-hand, POST /is-off, POST /switch");
        assertThat(status(to("/switch").DELETE())).isEqualTo(404);
        assertThat(answer(to("/switch").POST(body("x".repeat(4_097)))))
                .isEqualTo("400 the body has more than 4096 bytes");
        assertThat(answer(to("/switch").POST(HttpRequest.BodyPublishers.ofByteArray(new byte[] {(byte) 0xff}))))
                .isEqualTo("400 the body is not UTF-8 text");
        assertThat(sent).isEmpty();
    }

    @Test
    void whileTheConverterIsStoppedARequestIsRefused() throws Exception {
        lamp.converter.stop();
        assertThat(answer(to("/switch").POST(body(""))))
                .isEqualTo("409 refused: the converter lamp is stopped; start it first");
    }

    @Test
    void theAnswerIsTheOutcomeUnlessTheClientDoesNotWait() throws Exception {
        noCurrent = true;
        assertThat(answer(to("/switch").POST(body(""))))
                .startsWith("409 failed: ")
                .contains("no current");
        noCurrent = false;
        assertThat(answer(to("/switch").POST(body("")))).isEqualTo("200 handled: on, sent switch");
        assertThat(answer(to("/switch").header("Prefer", "respond-async").POST(body(""))))
                .isEqualTo("202 accepted; the outcome is not known yet");
    }

    @Test
    void aPageOfABrowserIsTurnedAwayAndItsAddressLineIsNot() throws Exception {
        assertThat(status(to("/switch").header("Origin", "http://evil.example").POST(body(""))))
                .isEqualTo(403);
        assertThat(status(to("/switch").header("Sec-Fetch-Site", "cross-site"))).isEqualTo(403);
        assertThat(status(to("/switch").header("Sec-Fetch-Site", "same-origin")))
                .isEqualTo(403);
        assertThat(sent).isEmpty();
        assertThat(status(to("/switch").header("Sec-Fetch-Site", "none"))).isEqualTo(200);
    }

    @ParameterizedTest
    @CsvSource({
        "localhost, 200",
        "127.0.0.1:8090, 200",
        "[::1]:8090, 200",
        "evil.example:8090, 403",
        "1.evil.example, 403"
    })
    void anotherSitesNameThatLeadsHereIsRefused(String host, int status) throws Exception {
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), monitor.port())) {
            socket.setSoTimeout(20_000);
            socket.getOutputStream()
                    .write(("GET /switch HTTP/1.1\r\nConnection: close\r\nHost: " + host + "\r\n\r\n")
                            .getBytes(StandardCharsets.US_ASCII));
            assertThat(new String(socket.getInputStream().readAllBytes(), StandardCharsets.US_ASCII))
                    .startsWith("HTTP/1.1 " + status);
        }
    }

    @Test
    void othersThanThisMachineNeedTheToken() throws Exception {
        assertThat(InetAddress.getByName(Door.loopback().host()).isLoopbackAddress())
                .isTrue();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new HttpMonitor("Buttons", 0).listenOn("0.0.0.0", "short"))
                .withMessage(
                        "the token has 5 characters; give it at least 16, since other computers can reach 0.0.0.0");
        try (HttpMonitor guarded = new HttpMonitor("Guarded", 0).listenOn("0.0.0.0", TOKEN)) {
            guarded.found("POST /is-off", "off").open();
            URI address = URI.create("http://127.0.0.1:" + guarded.port() + "/is-off");
            HttpRequest.Builder request = HttpRequest.newBuilder(address).POST(body(""));
            assertThat(answer(request)).startsWith("401 a token is needed");
            assertThat(status(request.copy().header("Authorization", "Bearer " + TOKEN + "x")))
                    .isEqualTo(401);
            assertThat(status(request.copy().header("Authorization", "Bearer " + TOKEN)))
                    .isEqualTo(204);
        }
    }

    private Socket begin(String request) throws IOException {
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), monitor.port());
        socket.setSoTimeout(60_000);
        socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
        return socket;
    }

    private static long threads() {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.getName().equals("evoloop-http"))
                .count();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "POST /switch HTTP/1.1\r\nHost: la",
                "POST /switch HTTP/1.1\r\nHost: localhost\r\nContent-Length: 5\r\n\r\nab"
            })
    void halfRequestsHoldFewThreadsForALimitedTime(String half) throws Exception {
        List<Socket> slow = new ArrayList<>();
        try {
            for (int i = 0; i < 300; i++) {
                try {
                    slow.add(begin(half));
                } catch (SocketException hungUp) {
                    // As expected.
                }
                assertThat(threads()).isLessThanOrEqualTo(RequestServer.MOST_REQUESTS);
            }
            for (Socket socket : slow) {
                requireHungUp(socket.getInputStream());
            }
        } finally {
            for (Socket socket : slow) {
                socket.close();
            }
        }
        assertThat(sent).isEmpty();
        assertThat(status(to("/switch").POST(body("")))).isEqualTo(200);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "POST /switch HTTP/1.1\r\nHost: la",
                "POST /switch HTTP/1.1\r\nHost: localhost\r\nContent-Length: 5\r\n\r\nab",
                ""
            })
    void clientsThatKeepOpeningHalfRequestsLockNobodyOut(String half) throws Exception {
        try (HalfRequests clients = new HalfRequests(monitor.port(), half)) {
            assertThat(HalfRequests.slowestOf(URI.create("http://127.0.0.1:" + monitor.port() + "/switch")))
                    .isLessThan(Duration.ofSeconds(5));
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "POST /switch HTTP/1.1\r\nContent-Length: 5\r\n\r\nab",
                "POST /nowhere HTTP/1.1\r\nHost: localhost\r\nContent-Length: 5\r\n\r\nab",
                "POST /nowhere HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\nFFFFFFFF\r\n"
            })
    void requestsThatBreakOffUseUpNoConnections(String request) throws Exception {
        // More than there may be connections.
        for (int i = 0; i < 100; i++) {
            try (Socket socket = begin(request)) {
                socket.shutdownOutput();
                socket.getInputStream().readAllBytes();
            } catch (SocketException hungUp) {
                // As expected.
            }
        }
        Awaitility.await()
                .atMost(Lamp.PATIENCE)
                .ignoreExceptionsInstanceOf(IOException.class)
                .until(() -> status(to("/switch").POST(body(""))) == 200);
    }

    /** The connection is closed, in whatever way; reading would throw after a minute. */
    private static void requireHungUp(InputStream answer) throws IOException {
        try {
            assertThat(answer.read()).isNegative();
        } catch (SocketException reset) {
            assertThat(reset).hasMessageContaining("reset");
        }
    }

    @Test
    void whatCannotBeListenedForIsRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> monitor.controller("power", "switch"))
                .withMessage("'power' is not a request; write one such as POST /power");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> monitor.controller("POST /switch", "switch"))
                .withMessage("'POST /switch' is there already");
        assertThatThrownBy(() -> new HttpMonitor("Second", monitor.port()).open())
                .isInstanceOf(IOException.class)
                .hasMessageContaining("cannot be listened on");
        assertThatThrownBy(() -> new HttpMonitor("Closed", 0).port()).hasMessage("Closed is not open");
    }
}
