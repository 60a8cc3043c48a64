package org.evoloop.http;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.api.BugDetectors;
import com.code_intelligence.jazzer.api.SilentCloseable;
import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import org.awaitility.Awaitility;
import org.evoloop.RecordingExecute;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Any request of a controller is answered or its connection closed; any answer of a device is understood or refused.
 */
@Timeout(30)
class HttpFuzzTest {
    /** How long a server that has too many connections may take until it has noticed that others are gone. */
    private static final Duration LIMIT = Duration.ofSeconds(20);

    /** Shared by all inputs, so that anything that one request leaves behind affects the next. */
    private static final class Asked {
        private static final HttpMonitor MONITOR = monitor();

        private static HttpMonitor monitor() {
            try {
                HttpMonitor monitor = new HttpMonitor("Buttons", 0)
                        .controller("POST /switch", "switch")
                        .controller("GET /switch", "switch")
                        .device("POST /by-hand", "switch")
                        .found("POST /is-off", "off")
                        .open();
                Lamp lamp = new Lamp(monitor, new RecordingExecute("Bulb", "switch"));
                Runtime.getRuntime().addShutdownHook(new Thread(() -> {
                    monitor.close();
                    lamp.close();
                }));
                return monitor;
            } catch (IOException failure) {
                throw new UncheckedIOException(failure);
            }
        }
    }

    @MethodSource("requests")
    @FuzzTest
    void aRequestOfAnyBytesDelaysNoOther(byte[] bytes) {
        try {
            answerTo(bytes);
        } catch (IOException hungUp) {
            // The server may close the connection.
        }
        String answer = Awaitility.await()
                .pollInSameThread()
                .pollDelay(Duration.ZERO)
                .pollInterval(Duration.ofMillis(10))
                .atMost(LIMIT)
                .ignoreExceptionsInstanceOf(IOException.class)
                .until(() -> answerTo(text("POST /is-off HTTP/1.0\r\n\r\n")), answered -> !answered.isEmpty());
        assertThat(answer).contains(" 204 ");
    }

    private static String answerTo(byte[] request) throws IOException {
        try (SilentCloseable ours = BugDetectors.allowNetworkConnections();
                Socket socket = new Socket(InetAddress.getLoopbackAddress(), Asked.MONITOR.port())) {
            // Otherwise its port could not be reused for a minute.
            socket.setSoLinger(true, 0);
            socket.getOutputStream().write(request);
            socket.shutdownOutput();
            return new String(socket.getInputStream().readAllBytes(), StandardCharsets.ISO_8859_1);
        }
    }

    @MethodSource("answers")
    @FuzzTest
    void anAnswerOfAnyBytesIsUnderstoodOrRefused(byte[] bytes) {
        try {
            ReceivedReply reply = ReceivedReply.read(new ByteArrayInputStream(bytes));
            assertThat(reply.status()).isBetween(200, 599);
            assertThat(reply.body()).hasSizeLessThanOrEqualTo(ReceivedReply.LONGEST_BODY);
        } catch (IOException refused) {
            assertThat(refused).hasMessageStartingWith("the answer");
        }
    }

    static List<byte[]> requests() {
        return List.of(
                text("POST /switch?level=7&where=hall%20way&=&x HTTP/1.1\r\nContent-Length: 2\r\n\r\nok"),
                text("GET /switch HTTP/1.0\r\nOrigin: http://elsewhere\r\n\r\n"),
                text("POST /by-hand HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\nFFFFFFFF\r\n"),
                text(
                        "POST /is-off?%zz=%C3%28 HTTP/1.1\r\nAuthorization: Bearer x\r\nContent-Length: 3\r\n\r\n\u00c3(\n"),
                text("GET mailto:a HTTP/9.9\r\nContent-Length: -1\r\n\r\n"),
                text("\r\n"));
    }

    static List<byte[]> answers() {
        return List.of(
                text("HTTP/1.1 200 OK\r\nContent-Length: 2\r\n\r\non"),
                text("HTTP/1.1 100 Continue\r\n\r\nHTTP/1.0 204 No Content\r\n\r\n"),
                text("HTTP/1.1 200 OK\r\nTransfer-Encoding: gzip, chunked\r\n\r\n2;x=y\r\non\r\n0\r\n\r\n"),
                text("HTTP/1.1 200 OK\r\nContent-Length: 999999999999999\r\n\r\nshort"),
                text("HTTP/1.1 302\r\nLocation: elsewhere\n\n"),
                text("SSH-2.0-OpenSSH\r\n"));
    }

    private static byte[] text(String bytes) {
        return bytes.getBytes(StandardCharsets.ISO_8859_1);
    }
}
