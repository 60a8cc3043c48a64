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
import org.jline.terminal.Size;
import org.jline.terminal.impl.ExternalTerminal;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The console on a terminal of JLine, key by key. */
@Timeout(60)
class TerminalIoTest {
    private static final String UP_AND_ERASE = "\r\033[%dA\033[J";

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
        terminal.setSize(Size.of(60, 24));
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
        console.addCommand(lamp.switchCommand());
        thread.start();
        screen.await("converter   lamp, stopped");
        screen.await("Type start to convert events; help lists all commands.");
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
        screen.await("error: unknown command 'swich'; did you mean switch?");
        screen.await("evoloop> ");
    }

    @Test
    void exclamationMarksMeanNothing() throws Exception {
        type("help !!\r");
        screen.await("error: unknown command '!!'");
    }

    @Test
    void controlCClearsALineAndEndsTheConsoleOnAnEmptyOne() throws Exception {
        type("stat");
        screen.await("stat");
        type("\003");
        screen.await("evoloop> ");
        type("start\r");
        screen.await("running: original off, new off; type switch");
        screen.await("evoloop> ");
        type("\003");
        running.get(20, TimeUnit.SECONDS);
    }

    @Test
    void linesAreBrokenBetweenWords() throws Exception {
        System.out.println("a line of the transcript that is longer than the terminal is wide");
        screen.await("a line of the transcript that is longer than the terminal is");
        screen.await("\nwide");
    }

    @Test
    void watchDrawsTheStatusAgainBelowWhatOthersPrintUntilAKeyIsPressed() throws Exception {
        type("watch\r");
        screen.await("now         events are refused until start");
        screen.await("(any key ends it)");
        lamp.converter.start();
        screen.await(UP_AND_ERASE.formatted(5));
        screen.await("now         waiting for an event");
        screen.await("(any key ends it)");

        System.out.println("from elsewhere");
        screen.await(UP_AND_ERASE.formatted(5) + "from elsewhere");
        screen.await("converter   lamp, running");

        type("\033[A");
        screen.await(UP_AND_ERASE.formatted(5));
        screen.await("evoloop> ");
        type("stop\r");
        screen.await("stopped: events are refused until start");
    }

    @Test
    void controlCEndsWatchAndNotTheConsole() throws Exception {
        type("watch 9\r");
        screen.await("(any key ends it)");
        type("\003");
        screen.await("evoloop> ");
    }

    @Test
    void anInterruptEndsTheConsoleWhileItWatches() throws Exception {
        type("watch 9\r");
        screen.await("(any key ends it)");
        thread.interrupt();
        running.get(20, TimeUnit.SECONDS);
    }

    @Test
    void watchNeedsATerminal() throws Exception {
        Captured errors = new Captured();
        assertThat(console.perform("watch", errors.stream, errors.stream)).isEqualTo(1);
        assertThat(errors.lines()).containsExactly("error: watch needs a terminal; status prints the same once");
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
