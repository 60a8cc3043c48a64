package org.evoloop.models;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.evoloop.natives.Pty;
import org.evoloop.time.Threads;
import org.evoloop.xmi.ModelReference;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** A device at a TCP port is learned from its device file. */
@SuppressWarnings("NullAway.Init") // set before each test
class LearnCommandTest {
    /** What is learned of it if it must not be cleared. */
    private static final String[] DIMMER = {
        "Off --power--> Bright",
        "Bright --power--> Off",
        "Bright --dim--> Dim",
        "Dim --power--> Off",
        "Dim --dim--> Bright"
    };

    @TempDir
    private Path folder;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();
    private final List<String> received = new CopyOnWriteArrayList<>();
    private ServerSocket server;
    private final CountDownLatch dimmed = new CountDownLatch(1);
    private volatile String state = "Off";

    /** What it waits for before each of its answers, for a time. */
    private volatile CountDownLatch slow = new CountDownLatch(0);

    @BeforeEach
    void serve() throws IOException {
        server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        Thread thread = new Thread(this::answer, "dimmer");
        thread.setDaemon(true);
        thread.start();
    }

    @AfterEach
    void end() throws IOException {
        server.close();
    }

    /** PWR switches it on and off, DIM only when it is on. */
    private void answer() {
        while (!server.isClosed()) {
            try (Socket socket = server.accept();
                    BufferedReader in =
                            new BufferedReader(new InputStreamReader(socket.getInputStream(), StandardCharsets.UTF_8));
                    PrintWriter answers = new PrintWriter(socket.getOutputStream(), true, StandardCharsets.UTF_8)) {
                for (String line = in.readLine(); line != null; line = in.readLine()) {
                    received.add(line);
                    slow.await(50, TimeUnit.MILLISECONDS);
                    answers.print(answer(line) + "\n");
                    answers.flush();
                }
            } catch (IOException | InterruptedException closed) {
                // The next connection, if there is one.
            }
        }
    }

    private String answer(String line) {
        switch (line) {
            case "STATE?" -> {
                return "is " + state;
            }
            case "PWR" -> state = state.equals("Off") ? "Bright" : "Off";
            case "DIM" -> {
                if (state.equals("Off")) {
                    return "ERR";
                }
                state = state.equals("Bright") ? "Dim" : "Bright";
                dimmed.countDown();
            }
            default -> {
                return "ERR";
            }
        }
        return "OK";
    }

    private int learn(String rules, String... options) throws IOException {
        return learn(described(rules), options);
    }

    private int learn(Path file, String... options) {
        CommandLine command = Main.learning();
        command.setOut(new PrintWriter(out, true));
        command.setErr(new PrintWriter(err, true));
        String[] all = new String[options.length + 1];
        all[0] = file.toString();
        System.arraycopy(options, 0, all, 1, options.length);
        return Main.run(command, all);
    }

    private Path described(String rules) throws IOException {
        return described("{lines: \"tcp://127.0.0.1:" + server.getLocalPort() + "\"}", rules);
    }

    private Path described(String connection, String rules) throws IOException {
        Path file = folder.resolve("dimmer.yaml");
        Files.writeString(file, """
                converter: dimmer
                connections: {dimmer: %s}
                device:
                  send: {power: PWR, dim: DIM, clear: CLR}
                  answer: {ok: OK, error: ERR, within: 5 s}
                  ask: {line: STATE?, within: 5 s}
                  state: {is Off: "Off", is Bright: Bright, is Dim: Dim}
                learn: {home: "Off", reset: power, settle: 5 ms%s}
                """.formatted(connection, rules));
        return file;
    }

    /** Learns in a process of its own, with a journal. */
    private Process learning(Path model) throws IOException {
        return learning(described(""), model);
    }

    private Process learning(Path file, Path model) throws IOException {
        return new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        System.getProperty("surefire.test.class.path", System.getProperty("java.class.path")),
                        Main.class.getName(),
                        "learn",
                        file.toString(),
                        "--output=" + model,
                        "--longest=20 ms",
                        "--journal=" + folder.resolve("answers"))
                .redirectErrorStream(true)
                .redirectOutput(folder.resolve("printed.txt").toFile())
                .start();
    }

    @Test
    void whenItIsToldToEndTheDeviceIsLeftAtHome() throws Exception {
        Process process = learning(folder.resolve("dimmer.mmd"));
        assertThat(dimmed.await(1, TimeUnit.MINUTES)).isTrue();

        process.destroy();

        assertThat(process.waitFor(1, TimeUnit.MINUTES)).isTrue();
        assertThat(state).isEqualTo("Off");
    }

    /** The program is the device: it lives until that is at home, and nobody begins another. */
    @Test
    void aProgramThatIsToldToEndLivesUntilItIsAtHome() throws Exception {
        Path log = Files.createFile(folder.resolve("program.log"));
        Files.writeString(folder.resolve("program.sh"), """
                at=Off
                echo begins >>%1$s
                while read line; do
                    case $line-$at in
                    STATE*) echo "is $at"; continue ;;
                    PWR-Off) at=Bright ;;
                    PWR-*) at=Off ;;
                    DIM-Bright) at=Dim ;;
                    DIM-Dim) at=Bright ;;
                    *) echo ERR; continue ;;
                    esac
                    echo OK
                    echo $at >>%1$s
                done
                """.formatted(log));
        String connection = "{program: [sh, " + folder.resolve("program.sh") + "]}";
        Process process = learning(described(connection, ""), folder.resolve("dimmer.mmd"));
        await().atMost(Duration.ofMinutes(1))
                .until(() -> Files.readAllLines(log).contains("Dim"));

        process.destroy();

        assertThat(process.waitFor(1, TimeUnit.MINUTES)).isTrue();
        assertThat(Files.readAllLines(log)).containsOnlyOnce("begins").endsWith("Off");
        assertThat(Files.readString(folder.resolve("printed.txt"))).contains("open: it was stopped");
        assertThat(process.exitValue()).isEqualTo(1);
    }

    @Test
    void theControllerNeedNotBeThere() throws IOException {
        Path file = described("");
        Files.writeString(
                file,
                Files.readString(file)
                        .replace("connections: {", "connections: {remote: {mqtt: \"mqtt://127.0.0.1:1\"}, ")
                        .replaceAll("(power|dim|clear): (PWR|DIM|CLR)", "$1: {to: dimmer, line: $2}")
                        .replace("state: {", "state: {from: dimmer, values: {")
                        .replace("is Dim: Dim}", "is Dim: Dim}}")
                        .replace(
                                "learn:", "controller: {press: {from: remote, topic: a, values: {b: power}}}\nlearn:"));
        assertThat(learn(file, "--output=" + folder.resolve("dimmer.mmd"), "--longest=50 ms"))
                .isZero();
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void itIsLearnedThroughASerialPort() throws IOException {
        Path port = folder.resolve("port");
        Path model = folder.resolve("dimmer.mmd");
        try (Pty cable = Pty.open(port)) {
            Threads.start("dimmer-cable", () -> answer(cable));
            assertThat(learn(
                            described("{lines: \"serial://" + port + "\", baud: 9600}", ", never: clear"),
                            "--output=" + model,
                            "--longest=50 ms"))
                    .as(out.toString())
                    .isEqualTo(1);
        }
        assertThat(transitions(model)).containsExactlyInAnyOrder(DIMMER);
    }

    private void answer(Pty cable) {
        StringBuilder heard = new StringBuilder();
        byte[] bytes = new byte[256];
        while (!cable.isHungUp()) {
            int length = cable.read(bytes, Pty.LONGEST_WAIT_MILLIS);
            heard.append(new String(bytes, 0, Math.max(0, length), StandardCharsets.UTF_8));
            for (int end = heard.indexOf("\n"); end >= 0; end = heard.indexOf("\n")) {
                byte[] said = (answer(heard.substring(0, end)) + "\n").getBytes(StandardCharsets.UTF_8);
                heard.delete(0, end + 1);
                cable.write(said, said.length);
            }
        }
    }

    private void killed(int times, long seed) throws Exception {
        Random random = new Random(seed);
        Path model = folder.resolve("dimmer.mmd");
        for (int kill = 0; kill < times; kill++) {
            Process process = learning(model);
            if (process.waitFor(random.nextInt(3_000), TimeUnit.MILLISECONDS)) {
                Files.delete(folder.resolve("answers").resolve("answers.log"));
            }
            process.destroyForcibly().waitFor();
        }
        assertThat(learning(model).waitFor()).isZero();
        List<String> settled = Files.readAllLines(folder.resolve("answers").resolve("answers.log"));
        List<String> edges = transitions(model);

        Files.delete(folder.resolve("answers").resolve("answers.log"));
        assertThat(learning(model).waitFor()).isZero();
        assertThat(transitions(model)).isEqualTo(edges);
        assertThat(Files.readAllLines(folder.resolve("answers").resolve("answers.log")))
                .hasSizeBetween(settled.size() - 1, settled.size() + 1);
    }

    private static List<String> transitions(Path model) {
        return ModelReference.parse(model.toString()).load().transitions().stream()
                .map(Object::toString)
                .toList();
    }

    @Test
    void killedAtAnyInstantItGoesOnAndAsksNothingTwice() throws Exception {
        killed(3, 1);
    }

    @Test
    @Tag("slow")
    void killedAHundredTimes() throws Exception {
        for (int seed = 0; seed < 20; seed++) {
            killed(5, seed);
            Files.delete(folder.resolve("answers").resolve("answers.log"));
        }
    }

    /** The device takes its time until the page has shown something, so that something is known, but not all. */
    @Test
    void thePageShowsWhatIsKnownSoFar() throws Exception {
        int port = freePort();
        CountDownLatch shown = new CountDownLatch(1);
        slow = shown;
        CompletableFuture<String> seen = CompletableFuture.supplyAsync(() -> await().pollInterval(Duration.ofMillis(20))
                        .atMost(Duration.ofMinutes(1))
                        .until(() -> picture(port), text -> text.contains("<svg")))
                .whenComplete((text, failed) -> shown.countDown());

        int status = learn("", "--output=" + folder.resolve("dimmer.mmd"), "--longest=50 ms", "--page=" + port);

        assertThat(status).isZero();
        assertThat(seen.get(1, TimeUnit.MINUTES)).contains("Off").contains("</svg>");
    }

    private static int freePort() throws IOException {
        try (ServerSocket probe = new ServerSocket(0)) {
            return probe.getLocalPort();
        }
    }

    private static String picture(int port) throws InterruptedException {
        try {
            return HttpClient.newHttpClient()
                    .send(
                            HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + port + "/picture"))
                                    .build(),
                            HttpResponse.BodyHandlers.ofString())
                    .body();
        } catch (IOException notYet) {
            return "";
        }
    }

    @Test
    void itIsLearnedAndWhatIsWrittenReadsBackWithoutAForbiddenEvent() throws IOException {
        Path model = folder.resolve("dimmer.mmd");

        int status = learn(
                ", never: clear", "--output=" + model, "--longest=50 ms", "--journal=" + folder.resolve("answers"));

        assertThat(out.toString())
                .contains(
                        "Off --dim--> Off: refused, seen ",
                        "tested to depth 1",
                        "open: clear was not tried: a rule forbids it");
        assertThat(status).isEqualTo(1);
        assertThat(received).doesNotContain("CLR");
        assertThat(state).isNotEmpty();
        assertThat(ModelReference.parse(model + "#original").load().transitions())
                .extracting(Object::toString)
                .containsExactlyInAnyOrder(DIMMER);

        int before = received.size();
        assertThat(learn(
                        ", never: clear",
                        "--output=" + folder.resolve("again.scxml"),
                        "--longest=50 ms",
                        "--journal=" + folder.resolve("answers")))
                .isEqualTo(1);
        assertThat(received.subList(before, received.size())).doesNotContain("PWR", "DIM");
    }

    @Test
    void aDeclaredModelIsTestedAndWhatDiffersIsNamed() throws IOException {
        Path drawn = folder.resolve("drawn.mmd");
        Files.writeString(drawn, """
                stateDiagram-v2
                    [*] --> Off
                    Off --> Bright : power
                    Bright --> Off : power
                    Bright --> Dim : dim
                    Dim --> Bright : dim
                """);
        String[] options = {"--output=" + folder.resolve("dimmer.mmd"), "--longest=50 ms", "--from=" + drawn};

        assertThat(learn("", options)).isZero();
        assertThat(out.toString()).contains("differs: Dim --power--> Off is not declared");

        out.getBuffer().setLength(0);
        Files.writeString(drawn, Files.readString(drawn) + "    Dim --> Off : power\n");
        assertThat(learn("", options)).isZero();
        assertThat(out.toString())
                .contains("tested to depth 0", "as " + drawn + " declares, as far as it was tried")
                .doesNotContain("differs");

        Files.writeString(drawn, "stateDiagram-v2\n[*] --> A\nA --> B : other\n");
        assertThat(learn("", options)).isEqualTo(2);
        assertThat(err.toString()).contains("has none of the events that dimmer is sent: clear, dim, power");
    }

    @Test
    void anEmptyBudgetEndsWithWhatIsOpen() throws IOException {
        assertThat(learn("", "--output=" + folder.resolve("dimmer.xml"), "--longest=50 ms", "--budget=1 ms"))
                .isEqualTo(1);
        assertThat(out.toString()).contains("open: the budget is spent");
    }

    @Test
    void wrongInputIsNamed() throws IOException {
        assertThat(learn("", "--output=" + folder.resolve("dimmer.png"))).isEqualTo(2);
        assertThat(err.toString()).contains(".mmd, .scxml or .xml");
        assertThat(learn("", "--output=" + folder.resolve("none").resolve("dimmer.mmd")))
                .isEqualTo(2);
        assertThat(err.toString()).contains("dimmer.mmd is in a folder that does not exist; make ");
        assertThat(received).isEmpty();
        assertThat(learn("", "--output=a.mmd", "--budget=soon")).isEqualTo(2);
        assertThat(err.toString()).contains("--budget is 'soon'");
        assertThat(learn("", "--output=a.mmd", "--longest=0 s")).isEqualTo(2);
        assertThat(err.toString()).contains("--longest is '0 s', which is no duration");
        assertThat(learn("", "--output=a.mmd", "--from=" + folder.resolve("missing.mmd")))
                .isEqualTo(2);
        assertThat(err.toString()).contains("missing.mmd");
        Path pins = described("");
        Files.writeString(
                pins,
                Files.readString(pins)
                        .replaceAll("connections: .*", "connections: {dimmer: {gpio: true}}")
                        .replaceAll("send: .*", "send: {power: {pulse: 23}}")
                        .replaceAll("(?m)^  (answer|ask): .*\\R", "")
                        .replaceAll("state: .*", "state: {contact: 22, closed: Bright, open: \"Off\"}"));
        assertThat(learn(pins, "--output=" + folder.resolve("pins.mmd"))).isEqualTo(2);
        assertThat(err.toString()).contains("the contacts of 'dimmer'", "cannot be learned yet");
        Path anywhere = described("");
        Files.writeString(anywhere, Files.readString(anywhere).replaceAll("(?m)^learn:.*\\R", ""));
        assertThat(learn(anywhere, "--output=a.mmd")).isEqualTo(2);
        assertThat(err.toString()).contains("does not say where each try begins");
        assertThat(learn(", never: cleer, presses-an-hour: 0", "--output=a.mmd"))
                .isEqualTo(2);
        assertThat(err.toString()).contains("dimmer.yaml:8", "'cleer'", "clear", "'0' is no whole number");
    }
}
