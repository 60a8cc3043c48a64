package org.evoloop.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.evoloop.JavaProcess;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** The console in a process of its own, on a pseudo-terminal of the operating system that does not know its size. */
@EnabledOnOs(OS.LINUX)
@Timeout(60)
class ConsoleTerminalTest {
    private final Screen screen = new Screen();
    private final Process program;
    private final OutputStream keyboard;

    ConsoleTerminalTest() throws IOException {
        // A shell that stayed would answer Ctrl-C as well, some of them with an exit status of their own.
        String command = JavaProcess.command(entry -> true, ConsoleProgram.class).stream()
                .map(word -> "'" + word + "'")
                .collect(Collectors.joining(" ", "exec ", ""));
        // A shell may have started the tests in the background, where programs ignore Ctrl-C.
        ProcessBuilder terminal = new ProcessBuilder(
                        "env", "--default-signal=INT", "TERM=xterm", "script", "-qec", command, "/dev/null")
                .redirectErrorStream(true);
        program = terminal.start();
        keyboard = program.getOutputStream();
        Thread thread = new Thread(this::show, "screen");
        thread.setDaemon(true);
        thread.start();
    }

    private void show() {
        try {
            program.getInputStream().transferTo(screen);
        } catch (IOException ended) {
            // What was shown until then counts.
        }
    }

    @AfterEach
    void leaveNoProcess() {
        program.descendants().forEach(ProcessHandle::destroyForcibly);
        program.destroyForcibly();
    }

    private void type(String keys) throws IOException {
        keyboard.write(keys.getBytes(StandardCharsets.UTF_8));
        keyboard.flush();
    }

    @Test
    void controlCClearsALineWithTextAndEndsTheProgramOnAnEmptyOne() throws Exception {
        screen.await("Type start to convert events");
        screen.await("evoloop> ");
        type("start and more");
        screen.await("start and more");
        type("\003");
        screen.await("evoloop> ");
        type("jline\r");
        // Not an error about 'start and morejline'.
        screen.await("LineReader");
        screen.await("evoloop> ");
        type("\003");
        assertEnds();
        assertThat(screen.text()).doesNotContain("error:", "running:");
    }

    @Test
    void controlCEndsOnlyWhatIsWatched() throws Exception {
        screen.await("evoloop> ");
        type("watch\r");
        screen.await("(any key ends it)");
        type("\003");
        screen.await("evoloop> ");
        type("exit\r");
        assertEnds();
    }

    @Test
    void controlCEndsTheProgramInTheMiddleOfACommand() throws Exception {
        screen.await("evoloop> ");
        type("wait\r");
        screen.await("waiting");
        type("\003");
        assertEnds();
    }

    private void assertEnds() throws InterruptedException {
        screen.await("ended, converter EXITED");
        assertThat(program.waitFor(20, TimeUnit.SECONDS)).isTrue();
        assertThat(program.exitValue()).isZero();
    }
}
