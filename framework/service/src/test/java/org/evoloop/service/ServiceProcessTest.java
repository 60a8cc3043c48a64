package org.evoloop.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.awaitility.Awaitility;
import org.evoloop.JavaProcess;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** An unattended program, in a process of its own. */
@Timeout(value = 120, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
@EnabledOnOs(OS.LINUX)
class ServiceProcessTest {
    private static final String NO_INPUT = "</dev/null";
    private static final String CLOSED_INPUT = "<&-";

    @TempDir
    private Path runtime;

    private final List<Process> processes = new ArrayList<>();
    private Duration patience = Instance.PATIENCE;

    @AfterEach
    void leaveNoProcess() throws InterruptedException {
        for (Process process : processes) {
            process.destroyForcibly().waitFor();
        }
    }

    private Process start(String input, String... options) throws IOException {
        ProcessBuilder builder =
                new ProcessBuilder("sh", "-c", "exec \"$0\" \"$@\" " + input).redirectErrorStream(true);
        builder.command().addAll(JavaProcess.command(LampProgram.class, options));
        builder.environment().put("XDG_RUNTIME_DIR", runtime.toString());
        Process process = builder.start();
        processes.add(process);
        return process;
    }

    private Path socket() {
        return runtime.resolve("evoloop/lamp.sock");
    }

    /** The lines that {@code ctl lamp} prints with these words, and its exit status. */
    private List<String> ctl(String... words) {
        ByteArrayOutputStream text = new ByteArrayOutputStream();
        PrintStream all = new PrintStream(text, true, StandardCharsets.UTF_8);
        List<String> arguments = new ArrayList<>(List.of("lamp"));
        arguments.addAll(List.of(words));
        int status = new Ctl(new Instances(Map.of("XDG_RUNTIME_DIR", runtime.toString())), all, all, false, patience)
                .call(arguments);
        all.println(status);
        return text.toString(StandardCharsets.UTF_8).lines().toList();
    }

    private void awaitRunning() {
        Awaitility.await()
                .atMost(60, TimeUnit.SECONDS)
                .until(() -> ctl("status").get(0).equals("converter   lamp, running"));
    }

    private static int end(Process process) throws InterruptedException {
        assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
        return process.exitValue();
    }

    @Test
    void withoutInputItRunsUntilItIsTerminated() throws Exception {
        Process lamp = start(NO_INPUT, "--start", "--name", "lamp");
        awaitRunning();
        assertThat(ctl("switch")).containsExactly("handled: on, sent switch", "0");
        assertThat(ctl("switch", "--no-wait")).containsExactly("0");
        JavaProcess.signal("HUP", lamp);
        assertThat(ctl("status").get(0)).isEqualTo("converter   lamp, running");

        JavaProcess.signal("TERM", lamp);

        assertThat(end(lamp)).isZero();
        assertThat(socket()).doesNotExist();
    }

    @Test
    void withItsInputClosedItTakesNothingForACommandAndEndsOnExit() throws Exception {
        Process lamp = start(CLOSED_INPUT, "--start", "--name", "lamp");
        awaitRunning();

        assertThat(ctl("exit")).containsExactly("0");

        assertThat(end(lamp)).isZero();
        assertThat(lamp.inputReader(StandardCharsets.UTF_8).lines()).noneMatch(line -> line.startsWith("error:"));
    }

    @Test
    void withoutStartTheEndOfItsInputIsItsEnd() throws Exception {
        assertThat(end(start(NO_INPUT, "--name", "lamp"))).isZero();
        assertThat(end(start(CLOSED_INPUT))).isZero();
        assertThat(socket()).doesNotExist();
    }

    @Test
    void aPressIsRefusedWhileTheLoopIsClosed() throws Exception {
        Process lamp = start(NO_INPUT, "--start", "--name", "lamp");
        awaitRunning();
        ctl("stop");

        assertThat(ctl("switch", "--no-wait"))
                .containsExactly("error: the converter lamp is stopped, so switch is refused; start it first", "1");
        assertThat(ctl("switch")).containsExactly("error: refused: the converter lamp is stopped; start it first", "1");

        JavaProcess.signal("TERM", lamp);
        assertThat(end(lamp)).isZero();
    }

    @Test
    void aNameIsRefusedWhileItsHolderLivesAndTakenOverWhenItWasKilled() throws Exception {
        Process first = start(NO_INPUT, "--start", "--name", "lamp");
        awaitRunning();
        Process second = start(NO_INPUT, "--start", "--name", "lamp");
        assertThat(end(second)).isEqualTo(2);
        assertThat(second.inputReader(StandardCharsets.UTF_8).lines())
                .containsExactly("error: an instance named lamp is running already (process " + first.pid()
                        + "); give this one another --name, or end that one: ctl lamp exit");

        JavaProcess.signal("KILL", first);
        assertThat(end(first)).isNotZero();
        assertThat(Files.exists(socket())).isTrue();
        assertThat(ctl("status")).containsExactly("error: no instance named lamp is running; none is", "2");

        Process third = start(NO_INPUT, "--start", "--name", "lamp");
        awaitRunning();
        assertThat(ctl("exit")).containsExactly("0");
        assertThat(end(third)).isZero();
    }

    @Test
    void aFrozenInstanceIsNotWaitedForForEver() throws Exception {
        Process lamp = start(NO_INPUT, "--start", "--name", "lamp");
        awaitRunning();
        JavaProcess.signal("STOP", lamp);
        patience = Duration.ofMillis(100);

        assertThat(ctl("status")).containsExactly("error: lamp does not answer: its process is stopped or hangs", "1");

        JavaProcess.signal("CONT", lamp);
        patience = Instance.PATIENCE;
        assertThat(ctl("exit")).containsExactly("0");
        assertThat(end(lamp)).isZero();
    }

    @Test
    void aFullDiskIsReportedWithTheFile() throws Exception {
        // A file that may not grow, as on a full disk.
        ProcessBuilder builder = new ProcessBuilder("sh", "-c", "ulimit -f 0; exec \"$0\" \"$@\"");
        List<String> command = JavaProcess.command(LampProgram.class, "--name", "lamp");
        command.add(1, "-XX:-UsePerfData");
        builder.command().addAll(command);
        builder.environment().put("XDG_RUNTIME_DIR", runtime.toString());
        Process lamp = builder.start();
        processes.add(lamp);

        assertThat(lamp.errorReader(StandardCharsets.UTF_8).lines())
                .anyMatch(line -> line.contains(runtime.resolve("evoloop/lamp.lock") + " cannot be written: "));
        assertThat(end(lamp)).isNotZero();
    }

    @Test
    void aConverterThatClosesItselfEndsTheProgramWithAnError() throws Exception {
        Process lamp = start(NO_INPUT, "--start", "--name", "lamp");
        awaitRunning();

        ctl("close");

        assertThat(end(lamp)).isEqualTo(1);
    }
}
