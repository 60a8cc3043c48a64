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
import org.evoloop.models.Tool;
import org.evoloop.page.Browser;
import org.evoloop.service.Ctl;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;

/**
 * The whole story: both models of a fan are drawn from nothing, by mouse and keyboard, while the fan runs with what it can do;
 * then the running fan is evolved to what was drawn. The fan's own log tells.
 */
@EnabledIf("org.evoloop.page.Browser#isThere")
class DrawnFanTest {
    /** What the fan does before. */
    private static final String RUNNING = """
            stateDiagram-v2
                [*] --> Off
                Off --> Low : power
                Low --> Off : power
                Low --> High : speed
                High --> Off : power
                High --> Low : speed
            """;

    @TempDir
    private Path running;

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

    private Process start(Path where, Class<?> program, String... arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                program.getName()));
        command.addAll(List.of(arguments));
        ProcessBuilder builder =
                new ProcessBuilder(command).directory(where.toFile()).redirectError(ProcessBuilder.Redirect.INHERIT);
        builder.environment().put("XDG_RUNTIME_DIR", sockets.toString());
        Process process = builder.start();
        processes.add(process);
        return process;
    }

    private int ctl(String... arguments) throws Exception {
        Process process = start(running, Ctl.class, arguments);
        process.getInputStream().readAllBytes();
        return process.waitFor();
    }

    @AfterEach
    void end() {
        processes.forEach(Process::destroyForcibly);
    }

    /** A fan that does what its remote control says, and no more. */
    private void run(Fan fan) throws IOException {
        Files.writeString(running.resolve("fan.mmd"), RUNNING);
        Files.writeString(running.resolve("fan.yaml"), """
                converter: fan
                models: {original: fan.mmd, new: fan.mmd}
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
        start(running, Main.class, "device", "run", "fan.yaml", "--start", "--name", "fan");
    }

    private static void draw(StudioWindow window) {
        for (String side : List.of("original", "new")) {
            window.addState(side, "Low");
            window.addState(side, "High");
            window.drag(side, "Off", "Low", "power");
            window.drag(side, "Low", "Off", "power");
            window.drag(side, "Low", "High", "speed");
            window.drag(side, "High", "Off", "power");
            window.drag(side, "High", "Low", "speed");
        }
        window.dragOwn("High", "Off", "overheat");
        window.drag("new", "High", "Off", "overheat");
        window.addState("new", "Breeze");
        window.drag("new", "Off", "High", "boost");
        window.drag("new", "Low", "Breeze", "breeze");
        window.drag("new", "High", "Breeze", "breeze");
        window.drag("new", "Breeze", "Off", "power");
        window.drag("new", "Breeze", "Off", "overheat");
        window.drag("new", "Breeze", "Off", "tm(30min)");
    }

    @Test
    void aRunningFanIsEvolvedToWhatIsDrawnFromNothing() throws Exception {
        Files.setPosixFilePermissions(sockets, PosixFilePermissions.fromString("rwx------"));
        try (Fan fan = new Fan();
                Browser browser = new Browser()) {
            run(fan);
            Process studio = start(folder, Main.class, "studio", ".", "--port", "0");
            BufferedReader printed = studio.inputReader(StandardCharsets.UTF_8);
            browser.looks(1280, 900, false);
            StudioWindow window = new StudioWindow(browser, printed.readLine());
            window.openAnother();
            browser.await("document.activeElement.id === 'begin'");
            browser.enter();
            window.awaitState("new", "Off");
            window.awaitState("original", "Off");
            draw(window);
            window.save();
            assertThat(Path.of(saved("original"))).content().contains("High --> Off : «spontaneous» overheat");
            assertThat(Tool.run("check", saved("original"), saved("new")).status())
                    .isZero();
            assertThat(Tool.run("diff", saved("original"), saved("new")).out()).contains("Breeze", "boost");

            window.button("#try", "boost");
            browser.await("document.querySelector('#try-new').textContent === 'High'");

            Awaitility.await().atMost(Duration.ofSeconds(60)).until(() -> ctl("fan", "status") == 0);
            assertThat(ctl("fan", "press", "boost")).isNotZero();
            browser.click("#change");
            browser.await("document.querySelector('#dialog .sum')");
            browser.click("#dialog .stages button[value=beside]");
            window.button("#dialog", "Try it beside");
            browser.await("document.querySelector('#dialog .said').innerText.includes('shadow')");
            assertThat(ctl("fan", "press", "boost")).isNotZero();
            window.button("#dialog", "Let it take over");
            Awaitility.await().atMost(Duration.ofSeconds(60)).until(() -> ctl("fan", "press", "boost") == 0);
            Awaitility.await().untilAsserted(() -> assertThat(fan.log).containsExactly("Off", "Low", "High"));
            assertThat(ctl("fan", "press", "power")).isZero();

            browser.click("#dialog .stages button[value=watch]");
            window.button("#dialog", "Roll back");
            Awaitility.await().atMost(Duration.ofSeconds(60)).until(() -> ctl("fan", "press", "boost") != 0);

            browser.click("#dialog .stages button[value=over]");
            probation(browser, "soon");
            window.button("#dialog", "Let it take over");
            browser.await("document.querySelector('#dialog .said').innerText.includes('is no number of seconds')");
            assertThat(ctl("fan", "press", "boost")).isNotZero();
            probation(browser, "600");
            window.button("#dialog", "Let it take over");
            browser.await("document.querySelector('#dialog .here').innerText.includes('took over')");
            List<String> before = List.of("Off", "Low", "High", "Off");
            assertThat(fan.log).isEqualTo(before);
            assertThat(ctl("fan", "press", "boost")).isZero();
            // In the new state, the fan itself goes on at high speed.
            assertThat(ctl("fan", "press", "breeze")).isZero();
            assertThat(ctl("fan", "press", "power")).isZero();
            Awaitility.await()
                    .untilAsserted(() ->
                            assertThat(fan.log).containsExactly("Off", "Low", "High", "Off", "Low", "High", "Off"));
            browser.click("#dialog .stages button[value=over]");
            cannotBeSaved(browser, window);
            assertThat(browser.complaints).allMatch(complaint -> complaint.contains("\"source\":\"network\""));
            assertThat(printed.ready()).as("it prints only its address").isFalse();
        }
    }

    private static void probation(Browser browser, String seconds) {
        browser.await("document.querySelector('#dialog input[aria-label=\"Probation in seconds\"]')");
        browser.evaluate("document.querySelector('#dialog input[aria-label=\"Probation in seconds\"]').select()");
        browser.type(seconds);
    }

    /** What cannot be saved does not take over either. */
    private void cannotBeSaved(Browser browser, StudioWindow window) throws Exception {
        window.button("#dialog", "✕");
        window.addState("new", "Storm");
        window.drag("new", "Off", "Storm", "storm");
        window.drag("new", "Storm", "Off", "power");
        Files.setPosixFilePermissions(Path.of(saved("new")), PosixFilePermissions.fromString("r--r--r--"));
        browser.click("#change");
        browser.await("document.querySelector('#dialog .sum')");
        browser.click("#dialog .stages button[value=over]");
        window.button("#dialog", "Let it take over");
        browser.await("document.querySelector('#dialog .said').innerText.includes('Nothing was done, since')");
        assertThat(ctl("fan", "press", "storm")).isNotZero();
    }

    private String saved(String model) {
        return folder.resolve(model + ".mmd").toString();
    }
}
