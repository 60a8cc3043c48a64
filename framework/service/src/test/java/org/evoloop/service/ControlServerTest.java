package org.evoloop.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The control socket and clients of every kind. */
@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD) // reading from a socket cannot be interrupted
class ControlServerTest {
    private final ManualClock clock = new ManualClock();
    private final CountDownLatch slowMayEnd = new CountDownLatch(1);
    private final List<AutoCloseable> open = new ArrayList<>();
    private Path socket = Path.of("");
    private ControlServer server;

    private final Commands commands = new Commands() {
        @Override
        public int perform(String line, PrintStream results, PrintStream errors) throws InterruptedException {
            switch (line) {
                case "slow" -> slowMayEnd.await();
                case "fail" -> {
                    errors.println("error: it failed");
                    return 1;
                }
                case "throw" -> throw new AssertionError("broken");
                case "much" -> results.println("x".repeat(4_000_000));
                default -> results.println("done " + line);
            }
            return 0;
        }

        @Override
        public boolean isEnding() {
            return false;
        }
    };

    @BeforeEach
    void open(@TempDir Path directory) throws IOException {
        socket = directory.resolve("lamp.sock");
        server = new ControlServer(socket, commands, clock);
    }

    @AfterEach
    void close() throws Exception {
        for (AutoCloseable one : open) {
            one.close();
        }
        slowMayEnd.countDown();
        server.close();
    }

    private Client client() throws IOException {
        Client client = new Client(socket);
        open.add(client);
        return client;
    }

    private void assertServes() throws IOException {
        Client client = client().send("status\n");
        assertThat(client.line()).isEqualTo("out done status");
        assertThat(client.line()).isEqualTo("end 0");
    }

    @Test
    void outputErrorsAndStatusAreSeparate() throws Exception {
        Client client = client().send("status\nfail\nthrow\n");

        assertThat(client.line()).isEqualTo("out done status");
        assertThat(client.line()).isEqualTo("end 0");
        assertThat(client.line()).isEqualTo("err error: it failed");
        assertThat(client.line()).isEqualTo("end 1");
        assertThat(client.line()).isEqualTo("err error: java.lang.AssertionError: broken");
        assertThat(client.line()).isEqualTo("end 1");
    }

    @Test
    void noOtherUserMayUseTheSocket() throws Exception {
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(socket)))
                .isEqualTo("rw-------");
    }

    @Test
    void aClientThatSendsNothingOrHalfALineOrWaitsForASlowCommandIsNotWaitedFor() throws Exception {
        client();
        client().send("stat");
        client().send("slow\n");

        assertServes();
    }

    @Test
    void aLineWithoutEndIsRefusedWithoutBeingKept() throws Exception {
        Client client = client();
        try {
            client.send("x".repeat(10_000_000));
        } catch (IOException cutOff) {
            // The server need not read all of it.
        }

        assertServes();
    }

    @Test
    void theLongestLineIsServedAndALongerOneRefused() throws Exception {
        String longest = "x".repeat(ControlConnection.LONGEST_LINE - 1);
        Client client = client().send(longest + "\n");
        assertThat(client.line()).isEqualTo("out done " + longest);
        assertThat(client.line()).isEqualTo("end 0");

        client.send(longest + "x".repeat(100_000));
        assertThat(client.line()).isEqualTo("err error: the command is longer than 4095 bytes");
        assertThat(client.line()).isEqualTo("end 2");
        assertThat(client.line()).isNull();
    }

    @Test
    void halfACommandIsNotPerformed() throws Exception {
        Client client = client().send("exi");
        client.channel.shutdownOutput();

        assertThat(client.line()).isEqualTo("err error: the command has no line feed at its end");
        assertThat(client.line()).isEqualTo("end 2");
    }

    @Test
    void aThousandConnectionsBlockOthersOnlyBriefly() throws Exception {
        for (int count = 0; count < 1000; count++) {
            client();
        }
        assertServes();

        for (int count = 0; count < 100; count++) {
            client().send("half a li");
        }
        assertServes();
    }

    @Test
    void aClientThatDoesNotReadItsAnswerIsNotWaitedFor() throws Exception {
        for (int count = 0; count < 2 * ControlServer.CLIENTS; count++) {
            client().send("much\nmuch\n");
        }
        assertServes();
    }

    @Test
    void aClientHasItsTimeForARequest() throws Exception {
        Client silent = client();
        Client half = client().send("stat");
        // Connections are accepted in order.
        assertServes();

        clock.advance(ControlConnection.LIMIT);

        assertThat(silent.line()).isNull();
        assertThat(half.line()).isNull();
        assertThat(clock.pendingTasks()).isZero();
        assertServes();
    }

    @Test
    void theSocketGoesAndConnectionsEnd() throws Exception {
        Client client = client().send("status\n");
        assertThat(client.line()).isEqualTo("out done status");
        assertThat(client.line()).isEqualTo("end 0");

        server.close();

        assertThat(client.line()).isNull();
        assertThat(socket).doesNotExist();
    }

    @Test
    void whatIsNoTextIsAnUnknownCommandLikeAnyOther() throws Exception {
        Client client = client();
        client.channel.write(ByteBuffer.wrap(new byte[] {(byte) 0xff, 0, (byte) 0xc3, '\n'}));

        assertThat(client.line()).startsWith("out done ");
        assertThat(client.line()).isEqualTo("end 0");
    }
}
