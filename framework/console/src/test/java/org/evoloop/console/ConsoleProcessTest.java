package org.evoloop.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.evoloop.JavaProcess;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The console in a process of its own, connected by pipes. */
@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD) // reading from a pipe cannot be interrupted
class ConsoleProcessTest {
    private static final int SIGINT = 2;

    private final Process program;
    private final Writer keyboard;
    private final BufferedReader screen;

    ConsoleProcessTest() throws IOException {
        program = new ProcessBuilder(
                        JavaProcess.command(entry -> !entry.getName().startsWith("jline"), ConsoleProgram.class))
                .redirectErrorStream(true)
                .start();
        keyboard = program.outputWriter(StandardCharsets.UTF_8);
        screen = program.inputReader(StandardCharsets.UTF_8);
    }

    @AfterEach
    void leaveNoProcess() {
        program.destroyForcibly();
    }

    private void type(String line) throws IOException {
        keyboard.write(line + "\n");
        keyboard.flush();
    }

    private void assertEndsInOrder() throws Exception {
        assertThat(screen.readLine()).isEqualTo("ended, converter EXITED");
        assertThat(screen.readLine()).isNull();
        assertThat(program.waitFor(20, TimeUnit.SECONDS)).isTrue();
        assertThat(program.exitValue()).isZero();
    }

    @Test
    void itWorksWithoutJLine() throws Exception {
        type("jline");
        assertThat(screen.readLine()).isEqualTo("no JLine");
        type("stop it");
        assertThat(screen.readLine()).isEqualTo("error: usage: stop");
        type("exit");
        assertEndsInOrder();
    }

    @Test
    void theEndOfThePipeIsAnExit() throws Exception {
        keyboard.close();
        assertEndsInOrder();
    }

    @Test
    void theSignalTermIsAnExit() throws Exception {
        type("start");
        assertThat(screen.readLine()).isEqualTo("running: original off, new off");
        type("jline");
        assertThat(screen.readLine()).isEqualTo("no JLine");

        JavaProcess.signal("TERM", program);

        assertEndsInOrder();
    }

    @Test
    void theSignalOfControlCIsAnExit() throws Exception {
        assumeFalse(ignoresControlC(), "a shell started the tests in the background, where programs ignore Control-C");
        type("jline");
        assertThat(screen.readLine()).isEqualTo("no JLine");

        JavaProcess.signal("INT", program);

        assertEndsInOrder();
    }

    /** Child processes inherit ignored signals. */
    private static boolean ignoresControlC() throws IOException {
        Path status = Path.of("/proc/self/status");
        if (!Files.exists(status)) {
            return false;
        }
        long ignored = 0;
        for (String line : Files.readAllLines(status)) {
            if (line.startsWith("SigIgn:")) {
                ignored = Long.parseUnsignedLong(
                        line.substring("SigIgn:".length()).strip(), 16);
            }
        }
        return (ignored & 1 << SIGINT - 1) != 0;
    }
}
