package org.evoloop.service;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.provider.MethodSource;

/** Whatever bytes a client sends, each of its commands is answered, and the next client is served. */
@Timeout(value = 30, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class ControlFuzzTest {
    private static final Echo ECHO = new Echo();

    /** Shared by all inputs, so that anything that one client leaves behind affects the next. */
    private static final class Echo implements Commands {
        private final Path socket;

        @SuppressWarnings("UnusedVariable")
        private final ControlServer server;

        Echo() {
            try {
                socket = Files.createTempDirectory("evoloop-fuzz").resolve("echo.sock");
                server = new ControlServer(socket, this, new ManualClock());
                Runtime.getRuntime().addShutdownHook(new Thread(this::close));
            } catch (IOException e) {
                throw new IllegalStateException(e);
            }
        }

        private void close() {
            server.close();
            socket.getParent().toFile().delete();
        }

        @Override
        public int perform(String line, PrintStream results, PrintStream errors) {
            results.println(line);
            return line.length() % 2;
        }

        @Override
        public boolean isEnding() {
            return false;
        }
    }

    @MethodSource("seeds")
    @FuzzTest
    void everyCommandIsAnsweredForAnyBytes(byte[] bytes) throws IOException {
        int answers = 0;
        try (Client client = new Client(ECHO.socket)) {
            try {
                ByteBuffer left = ByteBuffer.wrap(bytes);
                while (left.hasRemaining()) {
                    client.channel.write(left);
                }
                client.channel.shutdownOutput();
                String line = client.line();
                while (line != null) {
                    assertThat(line).matches("(?s)(out |err |end ).*");
                    answers += line.startsWith("end ") ? 1 : 0;
                    line = client.line();
                }
            } catch (IOException hungUp) {
                // The server need not read an endless line.
            }
        }
        assertThat(answers).isLessThanOrEqualTo(bytes.length + 1);
        try (Client next = new Client(ECHO.socket)) {
            assertThat(next.send("status\n").line()).isEqualTo("out status");
        }
    }

    static List<byte[]> seeds() {
        return List.of(
                "status\nstop\n".getBytes(StandardCharsets.UTF_8),
                "half a li".getBytes(StandardCharsets.UTF_8),
                "\n\r\n\u0000\n\u2028\n".getBytes(StandardCharsets.UTF_8),
                "x".repeat(ControlConnection.LONGEST_LINE).getBytes(StandardCharsets.UTF_8),
                new byte[] {(byte) 0xFF, (byte) 0xFE, '\n'});
    }
}
