package org.evoloop.line;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.provider.MethodSource;

/** Whatever bytes come from a device or a controller, over TCP or a serial port, exactly their lines are received. */
@Timeout(30)
class LinesFuzzTest {
    private static final int PATIENCE_SECONDS = 20;

    /** Supplies bytes; when they have been read and more is requested, the test is over. */
    private static final class Bytes extends InputStream implements LineTransport.Wire {
        private final ByteBuffer left;
        private final CountDownLatch read = new CountDownLatch(1);
        private final CountDownLatch closed = new CountDownLatch(1);

        Bytes(byte[] bytes) {
            left = ByteBuffer.wrap(bytes);
        }

        @Override
        public int read() {
            return left.hasRemaining() ? left.get() & 0xff : end();
        }

        @Override
        public int read(byte[] buffer, int start, int length) {
            int count = Math.min(length, left.remaining());
            left.get(buffer, start, count);
            return count > 0 ? count : end();
        }

        private int end() {
            read.countDown();
            try {
                closed.await();
            } catch (InterruptedException hurry) {
                Thread.currentThread().interrupt();
            }
            return -1;
        }

        @Override
        public InputStream input() {
            return this;
        }

        @Override
        public OutputStream output() {
            return OutputStream.nullOutputStream();
        }

        @Override
        public void close() {
            closed.countDown();
        }
    }

    @MethodSource("seeds")
    @FuzzTest
    void everyLineIsReceivedOnceAndInOrder(byte[] bytes) throws Exception {
        Bytes wire = new Bytes(bytes);
        List<String> heard = new ArrayList<>();
        try (ManualClock clock = new ManualClock();
                LineConnection connection = new LineConnection(() -> wire, clock)) {
            connection
                    .greet("STATE?")
                    .watch(Duration.ofSeconds(5), "PING")
                    .reading("battery", Pattern.compile("battery (.*)"), "%");
            connection.listen(heard::add);
            new LineMonitor("Wall", connection)
                    .controller(Map.of("click", "switch"))
                    .controller(Pattern.compile("click (?<times>.*) (?<where>.*)"), "switch")
                    .device(Pattern.compile("by hand(?<how>.*)"), "switch")
                    .found(Map.of("is off", "off"));
            connection.open();
            assertThat(wire.read.await(PATIENCE_SECONDS, TimeUnit.SECONDS)).isTrue();
            assertThat(connection.isUp()).isTrue();
            assertThat(heard).isEqualTo(lines(bytes));
            assertThat(connection.readings()).hasSizeLessThanOrEqualTo(1);
        }
    }

    /** The lines that {@link LineConnection} promises, determined in another way. */
    private static List<String> lines(byte[] bytes) throws IOException {
        List<String> lines = new ArrayList<>();
        ByteArrayOutputStream line = new ByteArrayOutputStream();
        for (byte each : bytes) {
            if (each != '\n' && each != '\r') {
                line.write(each);
                continue;
            }
            byte[] whole = line.toByteArray();
            line.reset();
            try {
                if (whole.length > 0 && whole.length <= LineReader.LONGEST) {
                    lines.add(StandardCharsets.UTF_8
                            .newDecoder()
                            .decode(ByteBuffer.wrap(whole))
                            .toString());
                }
            } catch (CharacterCodingException garbage) {
                // Not a line.
            }
        }
        return lines;
    }

    static List<byte[]> seeds() {
        return List.of(
                text("click\r\nis off\nbattery 93\n\n\rclick 2 hall\n"),
                text("by hand\nby hand twice\nbattery 1e999\nbattery -0.5\nhalf a li"),
                text("x".repeat(LineReader.LONGEST) + "\n" + "x".repeat(LineReader.LONGEST + 1) + "\nclick\n"),
                new byte[] {(byte) 0xC3, (byte) 0x28, '\n', (byte) 0xFF, '\r', 0, '\n', 'o', 'k', '\n'});
    }

    private static byte[] text(String lines) {
        return lines.getBytes(StandardCharsets.UTF_8);
    }
}
