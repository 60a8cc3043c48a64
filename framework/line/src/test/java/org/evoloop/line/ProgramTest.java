package org.evoloop.line;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import org.evoloop.LightBulb;
import org.evoloop.Logged;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.evolution.Values;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.Attempts;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Real programs, by their input and output or run once, and a real Unix-domain socket. */
@Timeout(120)
class ProgramTest {
    private static final Duration PATIENCE = Duration.ofSeconds(60);

    private final ManualClock clock = new ManualClock();
    private final BlockingQueue<String> received = new LinkedBlockingQueue<>();

    @TempDir
    private Path folder;

    @AfterEach
    void close() {
        clock.close();
    }

    private LineConnection connection(LineTransport transport) {
        LineConnection connection = new LineConnection(transport, clock);
        connection.listen(received::add);
        connection.open();
        return connection;
    }

    private static LineTransport shell(String script) {
        return LineTransport.program(List.of("sh", "-c", script));
    }

    private String next() throws InterruptedException {
        return String.valueOf(received.poll(PATIENCE.toSeconds(), TimeUnit.SECONDS));
    }

    private void awaitPause() {
        await().atMost(PATIENCE).until(() -> clock.pendingTasks() > 0);
    }

    @Test
    void linesGoToAProgramAndComeBack() throws Exception {
        try (LineConnection connection = connection(LineTransport.program(List.of("cat")))) {
            await().atMost(PATIENCE).until(connection::isUp);
            connection.send("hello");
            assertThat(next()).isEqualTo("hello");
            assertThat(connection.describe()).isEqualTo("the program cat");
        }
    }

    @Test
    void aProgramThatDiesIsStartedAgainWithGrowingPausesAndHalfALineIsDropped() throws Exception {
        try (LineConnection connection = connection(shell("echo whole; printf hal; exit 3"))) {
            assertThat(next()).isEqualTo("whole");
            await().atMost(PATIENCE).until(() -> connection.describe().contains("has ended with status 3"));
            assertThatThrownBy(() -> connection.send("too late")).hasMessageContaining("'too late' was not sent");
            for (Duration pause = Attempts.FIRST; pause.toMillis() < 2_000; pause = pause.multipliedBy(2)) {
                awaitPause();
                clock.advance(pause.minusMillis(1));
                assertThat(received).isEmpty();
                clock.advance(Duration.ofMillis(1));
                assertThat(next()).isEqualTo("whole");
            }
        }
    }

    @Test
    void aProgramThatDiesInTheMiddleOfAQuestionLeavesADoubt() throws Exception {
        try (LineConnection connection = connection(shell("read line; exit 1"))) {
            await().atMost(PATIENCE).until(connection::isUp);
            assertThatThrownBy(() -> connection.ask("toggle", Pattern.compile("ok"), Duration.ofHours(1), line -> {}))
                    .isInstanceOf(UnknownEffectException.class)
                    .hasMessageContaining("has ended with status 1");
        }
    }

    @Test
    void aProgramEndsWithTheConnectionEvenIfItIsStubbornAndDoesNotRead() throws Exception {
        LineConnection connection = connection(shell("trap '' TERM HUP; echo $$; while :; do sleep 1000; done"));
        ProcessHandle program = ProcessHandle.of(Long.parseLong(next())).orElseThrow();
        await().atMost(PATIENCE).until(() -> program.children().findAny().isPresent());
        ProcessHandle child = program.children().findAny().orElseThrow();
        connection.close();
        await().atMost(PATIENCE).until(() -> !program.isAlive() && !child.isAlive());
    }

    @Test
    void whatAProgramWritesToItsErrorsIsLoggedAndNoLine() throws Exception {
        try (Logged log = new Logged("org.evoloop.line");
                LineConnection connection = connection(shell("echo broken >&2; echo fine; exec cat"))) {
            assertThat(next()).isEqualTo("fine");
            await().atMost(PATIENCE).until(() -> log.lines().stream().anyMatch(line -> line.endsWith(": broken")));
            assertThat(received).isEmpty();
        }
    }

    @Test
    void noShellReadsACommand() throws Exception {
        String tricky = "$HOME; exit `id` > " + folder.resolve("x");
        try (LineConnection connection = connection(LineTransport.program(List.of("echo", tricky)))) {
            assertThat(next()).isEqualTo(tricky);
            assertThat(Files.list(folder)).isEmpty();
        }
        assertThatIllegalArgumentException()
                .isThrownBy(() -> LineTransport.program(List.of()))
                .withMessageContaining("names no program");
    }

    /** Ctrl-C on a terminal goes to all programs of its session. */
    @Test
    void aProgramDoesNotGetTheSignalsOfTheTerminal() throws Exception {
        String own = session(Files.readString(Path.of("/proc/self/stat")));
        try (LineConnection connection = connection(shell("cat /proc/self/stat; exec cat"))) {
            assertThat(session(next())).isNotEqualTo(own);
        }
        ProgramCommand command = new ProgramCommand(
                List.of("sh", "-c", "cat /proc/self/stat > " + folder.resolve("stat")), PATIENCE, clock);
        command.run(Values.NONE);
        assertThat(session(Files.readString(folder.resolve("stat")))).isNotEqualTo(own);
    }

    private static String session(String stat) {
        return stat.replaceFirst(".*[)]", "").strip().split(" ")[3];
    }

    @Test
    void aMissingProgramIsNamed() {
        try (LineConnection connection = connection(LineTransport.program(List.of("/no/such/kettle", "on")))) {
            await().atMost(PATIENCE)
                    .until(() -> connection.describe().startsWith("the program kettle cannot be started"));
        }
    }

    @Test
    void aSocketIsReadAndWrittenAtTheSameTimeAndOpenedAgain() throws Exception {
        Path path = folder.resolve("kettle");
        try (LineConnection connection = connection(LineTransport.unix(path))) {
            await().atMost(PATIENCE).until(() -> connection.describe().contains("kettle cannot be reached"));
            try (ServerSocketChannel server = ServerSocketChannel.open(StandardProtocolFamily.UNIX)) {
                server.bind(UnixDomainSocketAddress.of(path));
                for (int round = 0; round < 2; round++) {
                    awaitPause();
                    clock.advance(Attempts.LONGEST);
                    try (SocketChannel client = server.accept()) {
                        await().atMost(PATIENCE).until(connection::isUp);
                        connection.send("ping");
                        ByteBuffer heard = ByteBuffer.allocate(5);
                        while (heard.hasRemaining()) {
                            client.read(heard);
                        }
                        assertThat(new String(heard.array(), StandardCharsets.UTF_8))
                                .isEqualTo("ping\n");
                        client.write(ByteBuffer.wrap("pong\nhal".getBytes(StandardCharsets.UTF_8)));
                        assertThat(next()).isEqualTo("pong");
                    }
                    await().atMost(PATIENCE).until(() -> !connection.isUp());
                }
            }
        }
        assertThat(received).isEmpty();
    }

    private ProgramCommand command(Duration limit, String... words) {
        return new ProgramCommand(List.of(words), limit, clock);
    }

    @Test
    void aCommandObeysOrRefusesByItsStatus() throws Exception {
        Path file = folder.resolve("it's $(here)");
        command(PATIENCE, "touch", "${file}").run(Values.of("file", file.toString()));
        assertThat(file).exists();
        assertThatThrownBy(() -> command(PATIENCE, "sh", "-c", "exit 3").run(Values.NONE))
                .isInstanceOf(IOException.class)
                .isNotInstanceOf(UnknownEffectException.class)
                .hasMessage("the program sh has ended with status 3");
        assertThatThrownBy(() -> command(PATIENCE, "touch", "${file}").run(Values.NONE))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("carries no file");
        assertThatThrownBy(() -> command(PATIENCE, "/no/such").run(Values.NONE)).hasMessageContaining("its path");
        assertThat(clock.pendingTasks()).isZero();
    }

    @Test
    void aCommandThatTakesTooLongIsKilledAndLeavesADoubt() throws Exception {
        Path started = folder.resolve("started");
        PushMonitor wall = new PushMonitor("Wall");
        try (SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("lamp", clock))) {
            converter.addMonitor(wall);
            converter.addExecute(new RunExecute(
                    "Lamp",
                    Map.of(
                            "switch",
                            command(Duration.ofSeconds(5), "sh", "-c", "echo $$ > '" + started + "'; sleep 1000"))));
            converter.addKnowledge(LightBulb.withoutTimeout());
            converter.build();
            converter.start();
            wall.press("switch");
            await().atMost(PATIENCE).until(() -> Files.exists(started) && Files.size(started) > 1);
            ProcessHandle program = ProcessHandle.of(
                            Long.parseLong(Files.readString(started).strip()))
                    .orElseThrow();
            clock.advance(Duration.ofSeconds(5));
            await().atMost(PATIENCE).until(() -> !converter.status().doubt().isEmpty());
            assertThat(program.isAlive()).isFalse();
            assertThat(converter.history())
                    .anyMatch(entry -> entry.detail().contains("took longer than 5000 ms, so it was killed"));
        }
    }
}
