package org.evoloop.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.FutureTask;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.LoopState;
import org.evoloop.statemachine.ModelException;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The console as used by programs: lines in, lines out. */
class ConsoleTest {
    private static final String FRESH_COMPONENTS = """
            monitor     WallSwitch    ended    no thread
            analyze     EventAnalyze  ended    no thread
            plan        EventPlan     ended    no thread
            execute     Lamp          ended    no thread
            """;

    private final LampConverter lamp =
            new LampConverter(LoopConfig.defaults("lamp", new ManualClock()).withoutThreads());
    private final Captured out = new Captured();
    private final Captured err = new Captured();

    private Console console(InputStream in) {
        Console console = new Console(lamp.converter, in, out.stream, err.stream);
        console.addCommand(lamp.switchCommand());
        return console;
    }

    private int run(String... lines) {
        return console(input(lines)).run();
    }

    private static InputStream input(String... lines) {
        return new ByteArrayInputStream(String.join("\n", lines).concat("\n").getBytes(StandardCharsets.UTF_8));
    }

    @Test
    void startAndStopOpenAndCloseTheLoopAndPressesMeanwhileAreRefused() {
        run("switch", "start", "switch", "stop", "switch", "status --all");

        assertThat(err.lines())
                .containsOnly("error: the converter lamp is stopped, so switch is refused; start it first")
                .hasSize(2);
        assertThat(out.text().replaceAll("since [-0-9]+ [:0-9]+", "since then")).isEqualTo("""
                        running: original off, new off
                        stopped: events are refused until start
                        converter   lamp, stopped
                        states      original on, new on; last known, since then
                        now         events are refused until start
                        queue       0 waiting, highest 1, room for 8 presses; 0 dropped, 2 refused
                        events      1 handled, 0 ignored, 0 stale, 0 failed, 0 in progress, of 3
                                    observed
                        conversion  last 0 us, median 0 us, 99th percentile 0 us
                        """ + FRESH_COMPONENTS);
    }

    @Test
    void aPressThatWaitsTellsItsOutcomeAndHoldsUpNobody() throws Exception {
        Console console = console(input());
        console.addCommand(ConsoleCommand.press(lamp.wallSwitch, lamp.converter::controllerEvents));
        lamp.converter.start();
        FutureTask<Integer> waiting =
                new FutureTask<>(() -> console.performAndWait("press switch", out.stream, err.stream));
        Thread waits = new Thread(waiting);
        waits.start();
        while (lamp.converter.status().queue().depth() == 0) {
            Thread.onSpinWait();
        }
        assertThat(console.perform("press switch", out.stream, err.stream)).isZero();
        assertThat(console.performAndWait("press switch --no-wait", out.stream, err.stream))
                .isZero();
        assertThat(out.lines()).isEmpty();
        // It is another command of the application, and takes the steps, too.
        assertThat(console.perform("switch", out.stream, err.stream)).isZero();
        assertThat(waiting.get()).isZero();
        assertThat(out.lines()).containsExactly("handled: on, sent switch");
        assertThat(console.perform("press", out.stream, err.stream)).isEqualTo(2);
        assertThat(console.perform("press --wait", out.stream, err.stream)).isEqualTo(2);
        assertThat(console.perform("press timeout --wait", out.stream, err.stream))
                .isEqualTo(2);
        lamp.converter.stop();
        assertThat(console.perform("press switch --wait", out.stream, err.stream))
                .isEqualTo(1);
        assertThat(err.lines()).last().isEqualTo("error: refused: the converter lamp is stopped; start it first");
    }

    @Test
    void statusAsJsonIsOneLineWithEveryKey() {
        run("start", "status --json");

        String component = "{\"name\":\"%s\",\"role\":\"%s\",\"thread\":\"\",\"activity\":\"ended\","
                + "\"failures\":0,\"lastFailure\":\"\"}";
        assertThat(out.text())
                .endsWith(
                        "\n{\"name\":\"lamp\",\"loop\":\"running\",\"originalState\":\"off\",\"newState\":\"off\",\"system\":\"off\",\"evolution\":\"\",\"shadow\":\"\",\"doubt\":\"\",\"drift\":{\"acts\":0,\"unexplained\":0,\"text\":\"\",\"edges\":[]},\"lastKnownSince\":null,"
                                + "\"queue\":{\"depth\":0,\"capacity\":8,\"highest\":0,"
                                + "\"taken\":0,\"dropped\":0,\"refused\":0},"
                                + "\"events\":{\"observed\":0,\"handled\":0,\"ignored\":0,\"stale\":0,\"failed\":0,\"dropped\":0,"
                                + "\"refused\":0,\"waiting\":0,\"inProgress\":0},"
                                + "\"conversionTime\":{\"events\":0,\"lastNanos\":0,\"medianNanos\":0,"
                                + "\"percentile99Nanos\":0},"
                                + "\"components\":["
                                + component.formatted("WallSwitch", "monitor") + ","
                                + component.formatted("EventAnalyze", "analyze") + ","
                                + component.formatted("EventPlan", "plan") + ","
                                + component.formatted("Lamp", "execute") + "],"
                                + "\"function\":{\"state\":\"\",\"thread\":\"\",\"progress\":\"\",\"readings\":{}},"
                                + "\"timers\":[],\"faults\":[],\"link\":null}" + System.lineSeparator());
    }

    @Test
    void listShowsComponentsAndSpares() {
        run("list");

        assertThat(out.text()).isEqualTo(FRESH_COMPONENTS + "spares      spareSwitch, otherSwitch\n");
    }

    @Test
    void exchangePutsTheSpareInPlace() {
        run("start", "exchange WallSwitch spareSwitch", "list");

        assertThat(err.text()).isEmpty();
        assertThat(out.lines())
                .contains("spareSwitch has replaced WallSwitch")
                .contains("monitor     SpareSwitch   ended    no thread");
    }

    @Test
    void exchangeListsTheComponentsWhenTheNameIsWrong() {
        run("exchange WallSwitch Nothing", "exchange Nobody spareSwitch");

        assertThat(err.lines())
                .containsExactly(
                        "error: no spare is named Nothing; there are spareSwitch, otherSwitch",
                        "error: no component is named Nobody; there are WallSwitch, EventAnalyze, EventPlan, Lamp");
    }

    @Test
    void historyShowsTheLastEventsAndWhatBecameOfThem() {
        run("start", "switch", "switch", "switch", "history 2", "history");

        List<String> lines = out.lines().subList(1, out.lines().size());
        assertThat(lines).hasSize(5);
        assertThat(lines.get(0))
                .matches("2  \\d\\d:\\d\\d:00.000  switch \\(controller\\)  \\(on, on\\) -> \\(on, wait\\)  handled: "
                        + "new function of wait");
        assertThat(lines.get(2))
                .matches("1  \\d\\d:\\d\\d:00.000  switch \\(controller\\)  \\(off, off\\) -> \\(on, on\\)  handled: "
                        + "switch");
        assertThat(lines.subList(3, 5)).isEqualTo(lines.subList(0, 2));
    }

    @Test
    void helpListsTheCommandsAndExplainsOne() {
        run("help", "help switch");

        assertThat(out.text())
                .contains(
                        "  start  ",
                        "  stop  ",
                        "  status [--all|--json]  ",
                        "  list  ",
                        "  exchange COMPONENT SPARE  ")
                .contains("  history [N]  ", "  help [COMMAND]  ", "  exit  ")
                .contains("  switch                    operates the wall switch\n")
                .endsWith("switch\n  operates the wall switch\n  like a finger\n");
    }

    @Test
    void startAndStopSayWhatHappened() {
        run("start", "start", "switch", "switch", "stop", "start");

        assertThat(out.text().replaceAll("since [-0-9]+ [:0-9]+", "since then").lines())
                .containsExactly(
                        "running: original off, new off",
                        "already running: original off, new off",
                        "stopped: events are refused until start",
                        "running: original on, new wait");
    }

    @Test
    void whatIsForPeopleIsAtMostEightyColumnsWideInAPipe() {
        run("help", "help status", "status --all", "list");

        assertThat(out.lines()).allMatch(line -> line.length() <= 80);
        assertThat(out.text())
                .contains("  status [--all|--json]     shows states, device and current activity; --all\n"
                        + " ".repeat(28) + "adds queue, events, times and components; --json\n");
    }

    @Test
    void aMistakeIsOneLineOfErrorAndTheConsoleContinues() {
        run(
                "dance",
                "help swich",
                "STA",
                "exchange WallSwich otherSwitch",
                "exchange WallSwitch otherSwich",
                "exchange WallSwitch",
                "exit now",
                "status --jsn",
                "watch",
                "watch soon",
                "history none",
                "history 0",
                "switch \"wall",
                "",
                "  \t ",
                "start");

        assertThat(out.lines()).containsExactly("running: original off, new off");
        assertThat(err.lines())
                .containsExactly(
                        "error: unknown command 'dance'; help lists the commands",
                        "error: unknown command 'swich'; did you mean switch?",
                        "error: unknown command 'STA'; did you mean start or status?",
                        "error: no component is named WallSwich; did you mean WallSwitch?",
                        "error: no spare is named otherSwich; did you mean otherSwitch?",
                        "error: usage: exchange COMPONENT SPARE",
                        "error: usage: exit",
                        "error: status takes --all, --json or nothing, not '--jsn'; did you mean --json?",
                        "error: watch needs a terminal; status prints the same once",
                        "error: watch takes a number from 1 to 9999, not 'soon'",
                        "error: history takes a number from 1 to 999999999, not 'none'",
                        "error: history takes a number from 1 to 999999999, not '0'",
                        "error: the quote \" is not closed");
    }

    @Test
    void aCommandThatFailsPrintsItsMessageAndNoStackTrace() {
        Console console = console(input("state", "argument", "model", "io", "bug", "list"));
        console.addCommand(failing("state", new IllegalStateException("not now")));
        console.addCommand(failing("argument", new IllegalArgumentException("not that")));
        console.addCommand(failing("model", new ModelException("not so")));
        console.addCommand(failing("io", new IOException("not there")));
        console.addCommand(failing("bug", new NullPointerException()));

        assertThat(console.run()).isZero();
        assertThat(err.lines())
                .containsExactly(
                        "error: not now",
                        "error: not that",
                        "error: not so",
                        "error: not there",
                        "error: NullPointerException");
    }

    @Test
    void aCommandWithABugDoesNotEndTheProgram() {
        Console console = console(input("bug", "start"));
        console.addCommand(ConsoleCommand.of("bug", "fails", (arguments, to) -> {
            throw new StackOverflowError();
        }));

        assertThat(console.run()).isZero();

        assertThat(err.lines()).containsExactly("error: java.lang.StackOverflowError");
        assertThat(out.lines()).containsExactly("running: original off, new off");
    }

    private static ConsoleCommand failing(String name, Exception failure) {
        return ConsoleCommand.of(name, "fails", (arguments, out) -> {
            throw failure;
        });
    }

    @Test
    void quotesKeepBlanksTogether() {
        Console console = console(input("say  'two words' \"it's\" x\"y z\"'' ''"));
        console.addCommand(ConsoleCommand.of("say A B C D", "says", (words, to) -> to.println(words)));

        console.run();

        assertThat(out.text()).isEqualTo("[two words, it's, xy z, ]\n");
    }

    @Test
    void exitEndsTheConsoleAndClosesTheConverter() {
        assertThat(run("start", "exit", "status")).isZero();

        assertThat(out.lines()).hasSize(1);
        assertThat(lamp.converter.status().loop()).isEqualTo(LoopState.EXITED);
    }

    @Test
    void theEndOfTheInputIsAnExitEvenWithoutALineEnd() {
        InputStream cutOff = new ByteArrayInputStream("start\nswitch".getBytes(StandardCharsets.UTF_8));

        assertThat(console(cutOff).run()).isZero();

        assertThat(lamp.converter.status().states().original()).hasToString("on");
        assertThat(lamp.converter.status().loop()).isEqualTo(LoopState.EXITED);
    }

    @Test
    void anInputThatFailsIsReportedAndGivesAnotherExitStatus() {
        InputStream unplugged = new PipedInputStream();

        assertThat(console(unplugged).run()).isEqualTo(1);

        assertThat(err.text()).isEqualTo("error: the input cannot be read: Pipe not connected\n");
        assertThat(lamp.converter.status().loop()).isEqualTo(LoopState.EXITED);
    }

    @Test
    @Timeout(60)
    void anUnattendedConsoleOutlivesAnInputThatFails() throws Exception {
        Console console = console(new PipedInputStream());
        console.outliveInput();
        FutureTask<Integer> running = new FutureTask<>(console::run);
        Thread thread = new Thread(running, "console-under-test");
        thread.start();
        while (thread.isAlive() && (err.text().isEmpty() || thread.getState() != Thread.State.WAITING)) {
            Thread.onSpinWait();
        }

        console.end("SIGTERM", 0);

        assertThat(running.get()).isZero();
        assertThat(err.text()).isEqualTo("error: the input cannot be read: Pipe not connected\n");
    }

    @Test
    void aLineThatIsTooLongIsRefusedWithoutBeingKept() {
        String longest = "start" + " ".repeat(StreamIo.LONGEST_LINE - "start".length());

        run(longest + "x", longest, "status --jsn", "x".repeat(1_000_000));

        assertThat(out.lines()).containsExactly("running: original off, new off");
        assertThat(err.lines())
                .containsExactly(
                        "error: the command is longer than 4095 characters",
                        "error: status takes --all, --json or nothing, not '--jsn'; did you mean --json?",
                        "error: the command is longer than 4095 characters");
    }

    @Test
    void aRequestToEndWhileTheRunBeginsWaitsForWhatBegins() throws Exception {
        List<LoopState> begun = new ArrayList<>();
        try (PipedOutputStream keyboard = new PipedOutputStream();
                PipedInputStream pipe = new PipedInputStream(keyboard)) {
            Console console = console(pipe);
            console.onBegin(() -> {
                console.end("SIGTERM", 0);
                lamp.converter.start();
                begun.add(lamp.converter.status().loop());
            });

            assertThat(console.run()).isZero();
        }

        assertThat(begun).containsExactly(LoopState.RUNNING);
        assertThat(err.text()).isEmpty();
        assertThat(lamp.converter.status().loop()).isEqualTo(LoopState.EXITED);
    }

    @Test
    void anInterruptEndsTheConsoleThoughThePipeStaysOpen() throws Exception {
        try (PipedOutputStream keyboard = new PipedOutputStream();
                PipedInputStream pipe = new PipedInputStream(keyboard)) {
            FutureTask<Integer> running = new FutureTask<>(console(pipe)::run);
            Thread thread = new Thread(running, "console-under-test");
            thread.start();

            thread.interrupt();

            assertThat(running.get()).isZero();
            assertThat(lamp.converter.status().loop()).isEqualTo(LoopState.EXITED);
        }
    }

    @Test
    void aCommandOfTheSameNameIsRefused() {
        Console console = console(input());

        assertThatThrownBy(() -> console.addCommand(ConsoleCommand.of("stop", "stops it all", (words, to) -> {})))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("there is a command named stop already");
    }
}
