package org.evoloop.models.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.awaitility.Awaitility;
import org.evoloop.models.Main;
import org.evoloop.page.Browser;
import org.evoloop.service.Ctl;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;

/** A running fan that is evolved to what was drawn in the studio; the fan's own log tells. */
@EnabledIf("org.evoloop.page.Browser#isThere")
class EvolvedFanTest {
    private static final String ORIGINAL = """
            stateDiagram-v2
                [*] --> Off
                Off --> Low : power
                Low --> Off : power
                Low --> High : speed
                High --> Off : power
                High --> Low : speed
            """;

    @TempDir
    private Path folder;

    @TempDir
    private Path sockets;

    private final List<Process> processes = new ArrayList<>();

    /** A fan that takes lines, and writes down where it is. */
    private static final class Fan implements AutoCloseable {
        private static final Map<String, String> NEXT =
                Map.of("Off PWR", "Low", "Low PWR", "Off", "High PWR", "Off", "Low SPD", "High", "High SPD", "Low");

        final List<String> log = new CopyOnWriteArrayList<>(List.of("Off"));
        final ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());

        Fan() throws IOException {
            Thread thread = new Thread(this::serve, "fan");
            thread.setDaemon(true);
            thread.start();
        }

        private void serve() {
            try (Socket client = server.accept();
                    BufferedReader lines = new BufferedReader(
                            new InputStreamReader(client.getInputStream(), StandardCharsets.US_ASCII))) {
                for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                    String state = log.get(log.size() - 1);
                    String next = NEXT.get(state + " " + line);
                    if (next != null) {
                        log.add(next);
                    }
                    String answer = line.equals("STATE?") ? "is " + state : next == null ? "ERR" : "OK";
                    client.getOutputStream().write((answer + "\n").getBytes(StandardCharsets.US_ASCII));
                }
            } catch (IOException closed) {
                // The converter, or the test, has ended.
            }
        }

        @Override
        public void close() throws IOException {
            server.close();
        }
    }

    private Process start(Class<?> program, String... arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                program.getName()));
        command.addAll(List.of(arguments));
        ProcessBuilder builder =
                new ProcessBuilder(command).directory(folder.toFile()).redirectError(ProcessBuilder.Redirect.INHERIT);
        builder.environment().put("XDG_RUNTIME_DIR", sockets.toString());
        Process process = builder.start();
        processes.add(process);
        return process;
    }

    private int ctl(String... arguments) throws Exception {
        Process process = start(Ctl.class, arguments);
        process.getInputStream().readAllBytes();
        return process.waitFor();
    }

    @AfterEach
    void end() {
        processes.forEach(Process::destroyForcibly);
    }

    @Test
    void aRunningFanIsEvolvedToWhatWasDrawn() throws Exception {
        Files.setPosixFilePermissions(sockets, PosixFilePermissions.fromString("rwx------"));
        Files.writeString(folder.resolve("original.mmd"), ORIGINAL);
        Files.writeString(folder.resolve("new.mmd"), ORIGINAL);
        try (Fan fan = new Fan();
                Browser browser = new Browser()) {
            Files.writeString(folder.resolve("fan.yaml"), """
                    converter: fan
                    models: {original: original.mmd, new: new.mmd}
                    connections:
                      fan: {lines: "tcp://127.0.0.1:%d", greet: STATE?}
                    device:
                      send: {power: PWR, speed: SPD}
                      answer: {ok: OK, error: ERR.*, within: 2 s}
                      ask: {line: STATE?}
                      state: {is Off: "Off", is Low: Low, is High: High}
                    controller:
                      press: {remote power: power}
                    """.formatted(fan.server.getLocalPort()));
            start(Main.class, "device", "run", "fan.yaml", "--start", "--name", "fan");
            Awaitility.await().atMost(Duration.ofSeconds(60)).until(() -> ctl("fan", "status") == 0);
            assertThat(ctl("fan", "press", "boost")).isNotZero();

            Process studio = start(Main.class, "studio", ".", "--port", "0");
            browser.looks(1280, 900, false);
            StudioWindow window = new StudioWindow(
                    browser, studio.inputReader(StandardCharsets.UTF_8).readLine());
            window.openAnother();
            window.awaitState("new", "High");
            window.drag("new", "Off", "High", "boost");
            browser.click("#change");
            browser.await("document.querySelector('#dialog .sum').innerText.includes('3')");
            browser.click("#dialog .stages button[value=over]");
            browser.await("document.querySelector('#dialog .btn.main')");
            browser.click("#dialog .btn.main");
            browser.await("document.querySelector('#dialog .here').innerText.includes('took over')");

            assertThat(fan.log).containsExactly("Off");
            assertThat(ctl("fan", "press", "boost")).isZero();
            Awaitility.await().untilAsserted(() -> assertThat(fan.log).containsExactly("Off", "Low", "High"));

            browser.click("#dialog .stages button[value=watch]");
            browser.await(
                    "[...document.querySelectorAll('#dialog button')].some(one => one.textContent === 'Roll back')");
            browser.evaluate(
                    "[...document.querySelectorAll('#dialog button')].find(one => one.textContent === 'Roll back').click()");
            Awaitility.await().atMost(Duration.ofSeconds(60)).until(() -> ctl("fan", "press", "boost") != 0);
        }
    }
}
