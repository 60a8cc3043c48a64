package org.evoloop.mqtt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.evoloop.JavaProcess;
import org.evoloop.time.Threads;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** With Debian's Mosquitto, and a converter in a process of its own that is killed. */
class MqttBypassTest {
    private static final Duration LIMIT = Duration.ofSeconds(30);
    private static final String SET = "ring/set ";

    @TempDir
    private Path directory;

    private final List<Process> processes = new ArrayList<>();
    private final List<Converter> converters = new ArrayList<>();
    private Mosquitto broker;
    private Watcher watcher;
    private MqttBypass bypass;
    private int next;

    @BeforeEach
    void begin() throws Exception {
        broker = new Mosquitto(directory).start();
        watcher = new Watcher(broker);
        bypass = bypass().open();
    }

    private MqttBypass bypass() {
        return new MqttBypass(
                        new BrokerConnection(BrokerAddress.parse(broker.url()), "ring-bypass"),
                        RingProgram.BYPASS,
                        RingProgram.messages("passed"))
                .controller(RingProgram.CONTROLLER, RingProgram.events());
    }

    @AfterEach
    void end() throws InterruptedException {
        for (Process process : processes) {
            process.destroyForcibly().waitFor();
        }
        bypass.close();
        watcher.close();
        broker.close();
    }

    /** A converter's process, and its output. */
    private final class Converter {
        final List<String> said = new CopyOnWriteArrayList<>();
        final Process process;

        Converter() throws IOException {
            process = new ProcessBuilder(JavaProcess.command(RingProgram.class, broker.url()))
                    .redirectErrorStream(true)
                    .start();
            processes.add(process);
            converters.add(this);
            Threads.start("ring-output", this::read);
            await().atMost(LIMIT).until(() -> said.contains("ready"));
        }

        private void read() {
            try (BufferedReader lines = process.inputReader(StandardCharsets.UTF_8)) {
                lines.lines().forEach(said::add);
            } catch (IOException | java.io.UncheckedIOException killed) {
                // It has ended.
            }
        }

        void connect() throws IOException {
            process.getOutputStream().write('\n');
            process.getOutputStream().flush();
        }

        List<String> facts() {
            return said.stream()
                    .filter(line -> line.startsWith("fact "))
                    .map(line -> line.split(" ")[1])
                    .toList();
        }
    }

    private String press() throws Exception {
        String button = "p" + next++;
        watcher.publish(RingProgram.CONTROLLER, button, false);
        return button;
    }

    /** Which of the two has processed a button's event. */
    private List<String> dealtWith(String button) {
        List<String> by = new ArrayList<>();
        passed().stream().filter(button::equals).forEach(each -> by.add("passed"));
        converters.stream()
                .flatMap(converter -> converter.said.stream())
                .filter(line -> line.startsWith("press " + button + " "))
                .forEach(line -> by.add("converted"));
        return by;
    }

    /** Presses a button and waits until it is processed; returns by which of the two. */
    private String answered() throws Exception {
        String button = press();
        await().atMost(LIMIT)
                .pollInterval(Duration.ofMillis(1))
                .until(() -> !dealtWith(button).isEmpty());
        return dealtWith(button).get(0);
    }

    private List<String> passed() {
        return watcher.heard().stream()
                .filter(line -> line.startsWith(SET) && line.endsWith(" passed"))
                .map(line -> line.split(" ")[1])
                .toList();
    }

    private void assertNothingTwice() {
        for (int number = 0; number < next; number++) {
            assertThat(dealtWith("p" + number)).as("p" + number).hasSizeLessThanOrEqualTo(1);
        }
    }

    @Test
    void noEventIsBothConvertedAndPassedOnWheneverTheConverterIsKilled() throws Exception {
        await().atMost(LIMIT).until(bypass::isPassing);
        assertThat(answered()).isEqualTo("passed");
        int ofBefore = 0;
        for (int round = 1; round <= 3; round++) {
            Converter converter = new Converter();
            if (round > 1) {
                for (int press = 0; press < 5; press++) {
                    assertThat(answered()).isEqualTo("passed");
                }
            }
            converter.connect();
            // Each event is processed by exactly one of the two while one takes over from the other.
            int converted = 0;
            while (converted < 5) {
                converted = answered().equals("converted") ? converted + 1 : 0;
            }
            assertThat(bypass.isPassing()).isFalse();
            List<String> all = passed();
            List<String> ofOutage = all.subList(ofBefore, all.size());
            await().atMost(LIMIT)
                    .untilAsserted(() -> assertThat(converter.facts())
                            .as("the events that were passed on come first")
                            .containsExactlyElementsOf(ofOutage));
            for (int press = 0; press < 20; press++) {
                press();
                if (press == 10) {
                    converter.process.destroyForcibly();
                }
            }
            await().atMost(LIMIT).until(bypass::isPassing);
            ofBefore = all.size();
            assertThat(answered()).isEqualTo("passed");
            assertNothingTwice();
        }
    }

    @Test
    void aConverterThatEndsIsBypassedAndABypassThatWasAwayContinues() throws Exception {
        await().atMost(LIMIT).until(bypass::isPassing);
        assertThat(answered()).isEqualTo("passed");
        bypass.close();
        bypass = bypass().open();
        await().atMost(LIMIT).until(bypass::isPassing);
        assertThat(answered()).isEqualTo("passed");

        Converter converter = new Converter();
        converter.connect();
        await().atMost(LIMIT).until(() -> !bypass.isPassing());
        assertThat(answered()).isEqualTo("converted");
        assertThat(converter.facts()).containsExactly("p0", "p1");
        watcher.awaitNewest(RingProgram.BYPASS + "/passed", "");
        assertThat(converter.said).contains("press p2 B HANDLED");

        broker.stop();
        await().atMost(LIMIT).until(() -> !bypass.isPassing());
        converter.process.getOutputStream().close();
        await().atMost(LIMIT).until(() -> converter.said.contains("ended"));
        watcher.close();
        broker.start();
        watcher = new Watcher(broker);
        await().atMost(LIMIT).until(bypass::isPassing);
        assertThat(answered()).isEqualTo("passed");
    }
}
