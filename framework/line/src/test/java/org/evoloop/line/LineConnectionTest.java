package org.evoloop.line;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;
import static org.evoloop.line.LineServer.send;

import java.io.IOException;
import java.net.Socket;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import org.evoloop.Logged;
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.function.Reading;
import org.evoloop.time.Attempts;
import org.evoloop.time.ManualClock;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Over a real socket: a server that starts late, dies, hangs, floods or sends nonsense. */
class LineConnectionTest {
    private static final Duration PATIENCE = Duration.ofSeconds(LineServer.PATIENCE_SECONDS);

    private final SystemClock clock = new SystemClock();
    private final LineServer server = newServer();
    private final LineConnection connection = new LineConnection(server.transport(), clock);
    private final BlockingQueue<String> received = new LinkedBlockingQueue<>();

    private static LineServer newServer() {
        try {
            return new LineServer();
        } catch (IOException failure) {
            throw new AssertionError(failure);
        }
    }

    @AfterEach
    void close() {
        connection.close();
        server.close();
        clock.close();
    }

    private String next() throws InterruptedException {
        return String.valueOf(received.poll(LineServer.PATIENCE_SECONDS, TimeUnit.SECONDS));
    }

    @Test
    void aServerThatComesLateIsReachedAndItsAbsenceIsReportedOnce() throws Exception {
        int port = server.port();
        server.close();
        try (Logged log = new Logged("org.evoloop.line")) {
            connection.open();
            await().atMost(PATIENCE).until(() -> connection.describe().contains("refuses connections; check the port"));
            assertThat(connection.isUp()).isFalse();
            assertThat(connection.downSince()).isPresent();
            assertThatThrownBy(() -> connection.send("hello"))
                    .isInstanceOf(IOException.class)
                    .hasMessageEndingWith("so 'hello' was not sent");
            try (LineServer late = new LineServer(port)) {
                connection.greet("who is there?");
                assertThat(late.nextLine()).isEqualTo("who is there?");
                await().atMost(PATIENCE).until(connection::isUp);
                assertThat(connection.downSince()).isEmpty();
                assertThat(connection.describe()).isEqualTo("127.0.0.1:" + port);
            }
            assertThat(log.lines().stream().filter(line -> line.contains("refuses")))
                    .hasSize(1);
        }
    }

    @Test
    void aServerThatDiesIsConnectedToAgainAndHalfALineIsDropped() throws Exception {
        connection.greet("state?");
        connection.listen(received::add);
        connection.open();
        Socket first = server.client();
        assertThat(server.nextLine()).isEqualTo("state?");
        send(first, "whole\r\nhal");
        assertThat(next()).isEqualTo("whole");
        first.close();
        Socket second = server.client();
        assertThat(server.nextLine()).isEqualTo("state?");
        send(second, "f\nnext\n");
        assertThat(next()).isEqualTo("f");
        assertThat(next()).isEqualTo("next");
    }

    @Test
    void aServerThatHangsIsAskedAndThenLeft() throws Exception {
        Duration limit = Duration.ofMillis(100);
        try (ManualClock time = new ManualClock();
                LineConnection watched = new LineConnection(server.transport(), time)) {
            watched.watch(limit, "alive?");
            watched.listen(received::add);
            watched.open();
            server.client();
            awaitTimer(time);
            time.advance(limit);
            assertThat(server.nextLine()).isEqualTo("alive?");
            time.advance(limit);
            await().atMost(PATIENCE).until(() -> !watched.isUp());
            assertThat(watched.describe()).contains("'alive?' not answered");

            server.answers.put("alive?", "yes");
            awaitTimer(time);
            time.advance(Attempts.FIRST);
            server.client();
            for (int i = 0; i < 5; i++) {
                awaitTimer(time);
                time.advance(limit);
                assertThat(server.nextLine()).isEqualTo("alive?");
                assertThat(next()).isEqualTo("yes");
                time.advance(limit);
            }
            assertThat(watched.isUp()).isTrue();
        }
    }

    @Test
    void aListenerThatTakesItsTimeDoesNotMakeTheServerSilent() throws Exception {
        Duration limit = Duration.ofMillis(100);
        try (ManualClock time = new ManualClock();
                LineConnection watched = new LineConnection(server.transport(), time)) {
            watched.watch(limit, "alive?");
            watched.listen(line -> {
                time.advance(limit);
                received.add(line);
            });
            watched.open();
            send(server.client(), "busy\n");
            assertThat(next()).isEqualTo("busy");
            watched.send("not yet");
            assertThat(server.nextLine()).isEqualTo("not yet");
            time.advance(limit);
            assertThat(server.nextLine()).isEqualTo("alive?");
        }
    }

    /** What happens next is what the timer makes happen. */
    private static void awaitTimer(ManualClock time) {
        await().atMost(PATIENCE).until(() -> time.pendingTasks() == 1);
    }

    @Test
    void anAnswerThatIsLateEndsTheConnectionSinceItCouldBeTakenForTheNext() throws Exception {
        server.answers.put("fast", "OK");
        connection.listen(received::add);
        connection.open();
        await().atMost(PATIENCE).until(connection::isUp);
        Socket first = server.client();
        assertThat(connection.ask("fast", Pattern.compile("OK"), PATIENCE, heard -> {}))
                .isEqualTo("OK");
        assertThatThrownBy(() -> connection.ask("slow", Pattern.compile("OK"), Duration.ofMillis(50), heard -> {}))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("has not answered 'slow' within 50 ms");
        server.client();
        assertThat(first.getInputStream().read()).isNegative();
        assertThat(received).isEmpty();
    }

    @Test
    void aServerThatHangsUpInsteadOfAnsweringEndsTheWaitAtOnce() throws Exception {
        server.answers.put("go", "");
        connection.open();
        await().atMost(PATIENCE).until(connection::isUp);
        assertThatThrownBy(() -> connection.ask("go", Pattern.compile("OK"), Duration.ofDays(1), heard -> {}))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("hung up");
    }

    @Test
    void aLineDuringWhichTheWireIsLostMayHaveArrived() throws Exception {
        LineTransport.Wire lost = server.transport().open();
        lost.close();
        assertThatThrownBy(() -> new LineWriter(clock, "the lamp", why -> {}).write(lost, "SW"))
                .isInstanceOf(UnknownEffectException.class)
                .hasMessage("the lamp is lost; whether 'SW' has arrived is not known");
    }

    @Test
    void garbageIsReportedOnceAndAFloodIsReadToItsEnd() throws Exception {
        try (Logged log = new Logged("org.evoloop.line")) {
            connection.listen(received::add);
            connection.open();
            Socket client = server.client();
            byte[] garbage = new byte[100_000];
            for (int i = 0; i < garbage.length; i++) {
                garbage[i] = (byte) (i % 97 == 0 ? '\n' : 0xfe);
            }
            client.getOutputStream().write(garbage);
            send(client, "\n" + "x".repeat(1_000_000) + "\n" + "a line\n".repeat(10_000) + "end\n");
            String last = next();
            int lines = 0;
            while (last.equals("a line")) {
                last = next();
                lines++;
            }
            assertThat(last).isEqualTo("end");
            assertThat(lines).isEqualTo(10_000);
            assertThat(log.lines()).hasSize(2);
        }
    }

    @Test
    void whatTheDeviceReportsIsAReadingUntilTheDeviceIsGone() throws Exception {
        connection.reading("battery", Pattern.compile("bat=([0-9]+)"), "%");
        connection.reading("mode", Pattern.compile("mode=(.*)"), "");
        connection.open();
        Socket client = server.client();
        send(client, "bat=93\nmode=eco\n");
        await().atMost(PATIENCE)
                .until(() -> connection
                        .readings()
                        .equals(List.of(Reading.of("battery", 93.0, "%"), Reading.of("mode", "eco"))));
        client.close();
        await().atMost(PATIENCE).until(() -> connection.readings().isEmpty());
    }

    @Test
    void whatIsNotALineOrNoAddressIsRefused() {
        assertThatIllegalArgumentException().isThrownBy(() -> connection.send("two\nlines"));
        assertThatIllegalArgumentException().isThrownBy(() -> connection.greet(""));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> connection.reading("battery", Pattern.compile("bat"), "%"))
                .withMessageContaining("has no group");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> connection.watch(Duration.ZERO, "?"))
                .withMessageContaining("more than 0");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> LineTransport.tcp("fan", 0))
                .withMessage("'fan' port 0 is not an address; give a host and a port from 1 to 65535");
        assertThatThrownBy(() -> LineTransport.tcp("no-such-host.invalid", 1).open())
                .hasMessageContaining("there is no host no-such-host.invalid");
    }
}
