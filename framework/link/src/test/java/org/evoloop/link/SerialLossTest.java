package org.evoloop.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.evoloop.link.LinkException.Fault;
import org.evoloop.natives.Pty;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** What a serial link does, and what it leaves behind, when the other end disappears or stops reading. */
@EnabledOnOs(OS.LINUX)
@Timeout(60)
class SerialLossTest {
    /** More than a pseudo-terminal's buffers hold. */
    private static final byte[] TOO_MUCH = new byte[200_000];

    private static final int FAR_END_BUFFER = 4_096;
    private static final int REOPENINGS = 50;

    @TempDir
    Path folder;

    private String path;

    @BeforeEach
    void choosePath() {
        path = folder.resolve("device").toString();
    }

    @Test
    void aHangUpIsReportedAndAllResourcesAreReleased() throws Exception {
        Listener listener = new Listener();
        Pty pty = Pty.open(Path.of(path));
        Link link = open(listener);
        pty.hangUp();
        assertThat(listener.awaitLost())
                .hasMessage("serial port " + path + " at 4000000 baud hung up:"
                        + " the cable was pulled or the other end is gone; plug it in again");
        assertThat(SerialLeaks.terminals()).isEmpty();
        assertFault(Fault.HUNG_UP, () -> link.send(new byte[1]));
        SerialLeaks.awaitNoThreads();
        link.close();
    }

    @Test
    void aReaderWaitsAndNeverSpins() throws Exception {
        Listener listener = new Listener();
        long startNanos = System.nanoTime();
        try (Pty pty = Pty.open(Path.of(path));
                Link link = open(listener)) {
            for (int i = 0; i < 5; i++) {
                assertThat(pty.read(new byte[1], 200)).as("silence").isZero();
            }
            pty.hangUp();
            listener.awaitLost();
            assertThat(link.description()).contains(path);
        }
        long lifeNanos = System.nanoTime() - startNanos;
        assertThat(listener.threadCpuNanos()).as("of %d ns of life", lifeNanos).isLessThan(lifeNanos / 4);
        SerialLeaks.awaitNoThreads();
    }

    @Test
    void theCableCanBePulledAndPluggedInAgainManyTimes() throws Exception {
        for (int i = 0; i < REOPENINGS; i++) {
            Listener listener = new Listener();
            try (Pty pty = Pty.open(Path.of(path))) {
                Link link = open(listener);
                pty.write(new byte[] {(byte) i}, 1);
                assertThat(listener.awaitReceived(1)).containsExactly(i);
                pty.hangUp();
                assertThat(listener.awaitLost().fault()).isEqualTo(Fault.HUNG_UP);
                link.close();
            }
            assertThat(SerialLeaks.terminals()).isEmpty();
            SerialLeaks.awaitNoThreads();
        }
    }

    @Test
    void aPortCanBeOpenedAndClosedManyTimes() throws Exception {
        try (Pty pty = Pty.open(Path.of(path))) {
            int terminals = SerialLeaks.terminals().size();
            for (int i = 0; i < REOPENINGS; i++) {
                Listener listener = new Listener();
                Link link = open(listener);
                pty.write(new byte[] {(byte) i}, 1);
                assertThat(listener.awaitReceived(1)).containsExactly(i);
                link.close();
                assertThat(SerialLeaks.terminals()).hasSize(terminals);
                SerialLeaks.awaitNoThreads();
            }
        }
    }

    @Test
    void afterALossTheNextLinkCanBeOpenedAtOnce() throws Exception {
        CompletableFuture<Link> next = new CompletableFuture<>();
        Listener nextListener = new Listener();
        Pty first = Pty.open(Path.of(path));
        try (Link old = open(new Listener() {
                    @Override
                    void lost(LinkException cause) {
                        next.complete(open(nextListener));
                    }
                });
                Pty second = inPlaceOfTheFirst()) {
            first.hangUp();
            try (Link link = next.get(Listener.PATIENCE_SECONDS, TimeUnit.SECONDS)) {
                second.write(new byte[] {42}, 1);
                assertThat(nextListener.awaitReceived(1)).containsExactly(42);
                link.send(new byte[] {43});
                byte[] heard = new byte[2];
                assertThat(second.read(heard, 200)).isEqualTo(1);
                assertThat(heard[0]).isEqualTo((byte) 43);
            }
            assertFault(Fault.HUNG_UP, () -> old.send(new byte[1]));
        }
    }

    private Pty inPlaceOfTheFirst() throws IOException {
        Files.delete(Path.of(path));
        return Pty.open(Path.of(path));
    }

    @Test
    void aPeerThatNeverReadsLosesTheLinkAfterTheLimit() throws Exception {
        Listener listener = new Listener();
        try (Pty pty = Pty.open(Path.of(path))) {
            Link link = open(listener, 200);
            assertThatThrownBy(() -> link.send(TOO_MUCH))
                    .hasMessage("serial port " + path + " at 4000000 baud took no more bytes for 200 ms;"
                            + " check that the device at the other end is running");
            assertThat(listener.awaitLost().fault()).isEqualTo(Fault.NOT_READING);
            assertFault(Fault.NOT_READING, () -> link.send(new byte[1]));
            link.close();
            SerialLeaks.awaitNoThreads();
            assertThat(leftOver(pty))
                    .as("only what the terminal's far end had already accepted")
                    .isLessThan(2 * FAR_END_BUFFER);
        }
    }

    @Test
    void theThreadThatReceivesIsNotHeldLongerByAPeerThatNeverReads() throws Exception {
        CompletableFuture<Fault> sending = new CompletableFuture<>();
        try (Pty pty = Pty.open(Path.of(path))) {
            Link link =
                    SerialLink.open(new SerialSettings(path).withBaud(4_000_000).withSendLimitMillis(200));
            Listener listener = new Listener() {
                @Override
                synchronized void received(byte[] buffer, int length) {
                    try {
                        link.send(TOO_MUCH);
                    } catch (LinkException failure) {
                        sending.complete(failure.fault());
                    }
                }
            };
            listener.listenTo(link);
            pty.write(new byte[1], 1);
            assertThat(sending.get(Listener.PATIENCE_SECONDS, TimeUnit.SECONDS)).isEqualTo(Fault.NOT_READING);
            assertThat(listener.awaitLost().fault()).isEqualTo(Fault.NOT_READING);
            SerialLeaks.awaitNoThreads();
            link.close();
        }
    }

    private static int leftOver(Pty pty) {
        int total = 0;
        byte[] buffer = new byte[1_024];
        for (int length = pty.read(buffer, 0); length > 0; length = pty.read(buffer, 0)) {
            total += length;
        }
        return total;
    }

    @Test
    void aHangUpEndsAStuckSend() throws Exception {
        try (Pty pty = Pty.open(Path.of(path))) {
            Link link = open(new Listener(), 30_000);
            CompletableFuture<Void> stuck = stuckSend(pty, link);
            pty.hangUp();
            assertEnds(stuck, Fault.HUNG_UP);
            link.close();
            SerialLeaks.awaitNoThreads();
        }
    }

    @Test
    void closingEndsAStuckSend() throws Exception {
        try (Pty pty = Pty.open(Path.of(path))) {
            Link link = open(new Listener(), 1_000);
            CompletableFuture<Void> stuck = stuckSend(pty, link);
            link.close();
            assertEnds(stuck, Fault.NOT_READING, Fault.CLOSED);
            SerialLeaks.awaitNoThreads();
            assertThat(pty.clientPresent()).isFalse();
        }
    }

    /** A send whose first bytes have arrived and whose remaining ones cannot. */
    private static CompletableFuture<Void> stuckSend(Pty pty, Link link) {
        CompletableFuture<Void> stuck = CompletableFuture.runAsync(() -> link.send(TOO_MUCH));
        await().until(() -> pty.read(new byte[1], 200) > 0);
        return stuck;
    }

    private static void assertEnds(CompletableFuture<Void> sending, Fault... possible) {
        assertThat(sending)
                .failsWithin(Duration.ofSeconds(Listener.PATIENCE_SECONDS))
                .withThrowableThat()
                .havingRootCause()
                .isInstanceOfSatisfying(
                        LinkException.class,
                        failure -> assertThat(failure.fault()).isIn((Object[]) possible));
    }

    private Link open(Listener listener) {
        return open(listener, SerialSettings.DEFAULT_SEND_LIMIT_MILLIS);
    }

    /** Opens a line so fast that only the limit of a send matters. */
    private Link open(Listener listener, int sendLimitMillis) {
        return listener.listenTo(
                SerialLink.open(new SerialSettings(path).withBaud(4_000_000).withSendLimitMillis(sendLimitMillis)));
    }

    private static void assertFault(Fault fault, Runnable call) {
        assertThatThrownBy(call::run)
                .isInstanceOfSatisfying(
                        LinkException.class,
                        failure -> assertThat(failure.fault()).isEqualTo(fault));
    }
}
