package org.evoloop.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.LoopState;
import org.evoloop.time.ManualClock;
import org.jline.terminal.impl.ExternalTerminal;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The console on a terminal of JLine, key by key. */
@Timeout(60)
class TerminalIoTest {
    private final LampConverter lamp =
            new LampConverter(LoopConfig.defaults("lamp", new ManualClock()).withoutThreads());
    private final Console console = new Console(lamp.converter, System.in, System.out, System.err);
    private final PipedOutputStream keyboard = new PipedOutputStream();
    private final Screen screen = new Screen();
    private final PrintStream formerOut = System.out;
    private final PrintStream formerErr = System.err;
    private final FutureTask<Integer> running = new FutureTask<>(this::converse);
    private final Thread thread = new Thread(running, "console-under-test");

    private int converse() throws IOException {
        ExternalTerminal terminal =
                new ExternalTerminal("test", "ansi", new PipedInputStream(keyboard), screen, StandardCharsets.UTF_8);
        try (TerminalIo io = new TerminalIo(
                terminal,
                true,
                before -> before.isEmpty() ? List.of("status", "switch") : List.of(),
                Thread.currentThread()::interrupt)) {
            return console.run(io);
        }
    }

    @BeforeEach
    void open() throws InterruptedException {
        thread.start();
        screen.await("lamp: type help to see the commands");
        screen.await("evoloop> ");
    }

    @AfterEach
    void everythingIsAsItWasFound() throws Exception {
        keyboard.close();
        assertThat(running.get(20, TimeUnit.SECONDS)).isZero();
        assertThat(lamp.converter.status().loop()).isEqualTo(LoopState.EXITED);
        assertThat(System.out).isSameAs(formerOut);
        assertThat(System.err).isSameAs(formerErr);
    }

    private void type(String keys) throws IOException {
        keyboard.write(keys.getBytes(StandardCharsets.UTF_8));
        keyboard.flush();
    }

    @Test
    void tabCompletesACommand() throws Exception {
        type("sta\t");
        screen.await("status");
        type("\r");
        screen.await("converter   lamp, stopped");
    }

    @Test
    void linesOfOtherThreadsAppearAboveTheLineThatIsBeingEdited() throws Exception {
        type("stat");
        screen.await("stat");

        System.out.print("first, ");
        System.out.println("from elsewhere");
        System.err.println("and an error");

        screen.await("first, from elsewhere");
        screen.await("and an error");
        screen.await("evoloop> stat");
        type("us\r");
        screen.await("converter   lamp, stopped");
    }

    @Test
    void aMistakeIsShownAndTheNextPromptFollows() throws Exception {
        type("swich\r");
        screen.await("error: unknown command 'swich'; help lists the commands");
        screen.await("evoloop> ");
    }

    @Test
    void exclamationMarksMeanNothing() throws Exception {
        type("help !!\r");
        screen.await("error: unknown command '!!'");
    }

    @Test
    void controlCEndsTheConsoleInTheMiddleOfALine() throws Exception {
        type("stat");
        screen.await("stat");
        type("\003");
        running.get(20, TimeUnit.SECONDS);
    }

    @Test
    void controlCEndsTheConsoleInTheMiddleOfACommand() throws Exception {
        CountDownLatch begun = new CountDownLatch(1);
        console.addCommand(ConsoleCommand.of("hang", "never returns", (arguments, out) -> {
            begun.countDown();
            new CountDownLatch(1).await();
        }));
        type("hang\r");
        begun.await();
        type("\003");
        running.get(20, TimeUnit.SECONDS);
    }

    @Test
    void controlDEndsTheConsole() throws Exception {
        type("\004");
        running.get(20, TimeUnit.SECONDS);
    }

    @Test
    void anInterruptEndsTheConsoleAsASignalDoes() throws Exception {
        thread.interrupt();
        running.get(20, TimeUnit.SECONDS);
    }
}
