package org.evoloop.roomba.simulator.webcam;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.api.BugDetectors;
import com.code_intelligence.jazzer.api.SilentCloseable;
import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Whatever a viewer of the simulated camera sends, it is answered or its connection closed, and the next one is served.
 */
@Timeout(30)
class MjpegFuzzTest {
    /** How long a server that has too many connections may take until it has noticed that others are gone. */
    private static final Duration LIMIT = Duration.ofSeconds(20);

    private static final MjpegServer SERVER = server();

    private static MjpegServer server() {
        try {
            // There will be no picture, so a stream ends at once.
            Newest<byte[]> none = new Newest<>();
            none.close();
            MjpegServer server = new MjpegServer(none, 0);
            Runtime.getRuntime().addShutdownHook(new Thread(server::close));
            return server;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @MethodSource("seeds")
    @FuzzTest
    void aRequestOfAnyBytesDelaysNoOther(byte[] bytes) throws IOException {
        try {
            answerTo(bytes);
        } catch (IOException hungUp) {
            // The server may close the connection.
        }
        String page = Awaitility.await()
                .pollInSameThread()
                .pollDelay(Duration.ZERO)
                .pollInterval(Duration.ofMillis(10))
                .atMost(LIMIT)
                .ignoreExceptionsInstanceOf(IOException.class)
                .until(
                        () -> answerTo("GET / HTTP/1.0\r\n\r\n".getBytes(StandardCharsets.US_ASCII)),
                        answered -> !answered.isEmpty());
        assertThat(page).contains(" 200 ").contains("Simulated Roomba");
    }

    private static String answerTo(byte[] request) throws IOException {
        try (SilentCloseable ours = BugDetectors.allowNetworkConnections();
                Socket socket = new Socket(InetAddress.getLoopbackAddress(), SERVER.port())) {
            // Otherwise its port could not be reused for a minute.
            socket.setSoLinger(true, 0);
            socket.getOutputStream().write(request);
            socket.shutdownOutput();
            return new String(socket.getInputStream().readAllBytes(), StandardCharsets.ISO_8859_1);
        }
    }

    static List<byte[]> seeds() {
        return List.of(
                text("GET /stream HTTP/1.1\r\nHost: localhost\r\n\r\n"),
                text("GET /frame.jpg HTTP/1.0\r\n\r\n"),
                text("HEAD /nothing%00 HTTP/1.1\r\nConnection: close\r\n\r\n"),
                text("POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\nFFFFFFFF\r\n"),
                text("GET http:// HTTP/9.9\r\nContent-Length: -1\r\n\r\n"),
                text("\r\n"));
    }

    private static byte[] text(String request) {
        return request.getBytes(StandardCharsets.ISO_8859_1);
    }
}
