package org.evoloop.serial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import java.util.regex.Pattern;
import org.evoloop.LightBulb;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.line.LineConnection;
import org.evoloop.line.LineExecute;
import org.evoloop.line.LineMonitor;
import org.evoloop.loop.LoopConfig;
import org.evoloop.natives.Pty;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Lines over a real pseudo-terminal that appears late, is unplugged and plugged in again. */
@EnabledOnOs(OS.LINUX)
@Timeout(120)
class SerialTransportTest {
    private static final Duration PATIENCE = Duration.ofSeconds(30);

    @TempDir
    private Path folder;

    private final SystemClock clock = new SystemClock();

    @AfterEach
    void close() {
        clock.close();
    }

    private static String read(Pty pty, String until) {
        StringBuilder heard = new StringBuilder();
        byte[] buffer = new byte[256];
        await().atMost(PATIENCE).until(() -> {
            int length = pty.read(buffer, Pty.LONGEST_WAIT_MILLIS);
            if (length > 0) {
                heard.append(new String(buffer, 0, length, StandardCharsets.UTF_8));
            }
            return heard.toString().endsWith(until);
        });
        return heard.toString();
    }

    private static void write(Pty pty, String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        pty.write(bytes, bytes.length);
    }

    private SystemEventConverter converter(LineConnection connection) {
        SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("lamp", clock));
        converter.addMonitor(new LineMonitor("Wall", connection).controller(Map.of("click", "switch")));
        converter.addExecute(new LineExecute("Lamp", connection, Map.of("switch", "SW")));
        converter.addKnowledge(LightBulb.withoutTimeout());
        converter.addLink(connection);
        converter.build();
        return converter;
    }

    @Test
    void linesGoBothWaysAndContinueAfterTheCableWasPulled() throws Exception {
        Path port = folder.resolve("lamp");
        try (LineConnection connection =
                        new LineConnection(SerialTransport.at(port.toString(), 9600), clock).greet("HELLO");
                SystemEventConverter converter = converter(connection)) {
            converter.start();
            connection.open();
            await().atMost(PATIENCE).until(() -> connection.describe().contains("does not exist; plug the cable in"));
            try (Pty pty = Pty.open(port)) {
                assertThat(read(pty, "\n")).isEqualTo("HELLO\n");
                write(pty, "click\r\n");
                assertThat(read(pty, "\n")).isEqualTo("SW\n");
                await().atMost(PATIENCE)
                        .until(() ->
                                converter.status().states().original().name().equals("on"));
                write(pty, "cli");
                pty.hangUp();
            }
            await().atMost(PATIENCE).until(() -> !converter.status().link().up());
            try (Pty pty = Pty.open(port)) {
                assertThat(read(pty, "\n")).isEqualTo("HELLO\n");
                write(pty, "ck\nanswer\n");
                write(pty, "click\n");
                await().atMost(PATIENCE)
                        .until(() ->
                                converter.status().states().evolved().name().equals("wait"));
            }
        }
    }

    @Test
    void anAnswerComesAsALineToo() throws Exception {
        Path port = folder.resolve("meter");
        try (Pty pty = Pty.open(port);
                LineConnection connection = new LineConnection(SerialTransport.at(port.toString(), 115_200), clock)) {
            connection.open();
            await().atMost(PATIENCE).until(connection::isUp);
            write(pty, "OK\n");
            connection.send("?");
            assertThat(read(pty, "\n")).isEqualTo("?\n");
            Thread answer = new Thread(() -> {
                read(pty, "\n");
                write(pty, "OK 7\n");
            });
            answer.start();
            assertThat(connection.ask("value", Pattern.compile("OK [0-9]+"), PATIENCE, heard -> {}))
                    .isEqualTo("OK 7");
            answer.join();
        }
    }

    @Test
    void whatIsNoPortIsRefused() {
        assertThatIllegalArgumentException().isThrownBy(() -> SerialTransport.at("", 9600));
        assertThatIllegalArgumentException().isThrownBy(() -> SerialTransport.at("/dev/ttyUSB0", 0));
        assertThatThrownBy(() -> SerialTransport.at(folder.toString(), 9600).open())
                .hasMessageContaining("is not a serial port");
    }
}
