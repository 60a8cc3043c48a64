package org.evoloop.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.RandomAccessFile;
import java.util.Arrays;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.evoloop.link.LinkException.Fault;
import org.evoloop.natives.Pty;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** A serial link on a real pseudo-terminal. */
@EnabledOnOs(OS.LINUX)
@Timeout(60)
class SerialLinkTest {
    private static final int MEGABYTE = 1 << 20;
    private static final byte[] COMMAND = {(byte) 128, (byte) 173};

    @Test
    void aMegabyteComesBackUnchangedAndInOrder() throws Exception {
        byte[] sent = new byte[MEGABYTE];
        new Random(1).nextBytes(sent);
        Listener listener = new Listener();
        try (Pty pty = Pty.open();
                Peer peer = Peer.echoing(pty);
                Link link = open(pty, listener)) {
            int window = 2_048;
            for (int start = 0; start < sent.length; start += window) {
                link.send(Arrays.copyOfRange(sent, start, start + window));
                // The terminal drops what does not fit, like a UART, so at most one window is in transit.
                listener.awaitReceived(start + window);
            }
            assertThat(listener.received()).isEqualTo(sent);
            assertThat(peer.awaitHeard(sent.length)).isEqualTo(sent);
            assertThat(pty.droppedBytes()).isZero();
        }
        assertThat(listener.isLost()).as("closing is no loss").isFalse();
    }

    @Test
    void aMegabyteInOneSendArrivesWhole() throws Exception {
        byte[] sent = new byte[MEGABYTE];
        new Random(2).nextBytes(sent);
        try (Pty pty = Pty.open();
                Peer peer = Peer.listening(pty);
                Link link = open(pty, new Listener())) {
            link.send(sent);
            assertThat(peer.awaitHeard(sent.length)).isEqualTo(sent);
        }
    }

    @Test
    void sendsOfSeveralThreadsStayWhole() throws Exception {
        int threads = 4;
        int rounds = 50;
        try (Pty pty = Pty.open();
                Peer peer = Peer.listening(pty);
                Link link = open(pty, new Listener())) {
            CompletableFuture<?>[] senders = new CompletableFuture<?>[threads];
            for (int i = 0; i < threads; i++) {
                byte[] command = new byte[35];
                Arrays.fill(command, (byte) i);
                senders[i] = CompletableFuture.runAsync(() -> {
                    for (int round = 0; round < rounds; round++) {
                        link.send(command);
                    }
                });
            }
            CompletableFuture.allOf(senders).get(Listener.PATIENCE_SECONDS, TimeUnit.SECONDS);
            byte[] heard = peer.awaitHeard(threads * rounds * 35);
            for (int start = 0; start < heard.length; start += 35) {
                assertThat(Arrays.copyOfRange(heard, start, start + 35)).containsOnly(heard[start]);
            }
        }
    }

    @Test
    void whatIsSentRightBeforeCloseArrives() throws Exception {
        try (Pty pty = Pty.open();
                Peer peer = Peer.listening(pty)) {
            for (int round = 1; round <= 20; round++) {
                Link link = open(pty, new Listener());
                link.send(COMMAND);
                link.close();
                assertThat(peer.awaitHeard(round * COMMAND.length)).hasSize(round * COMMAND.length);
            }
        }
    }

    @Test
    void aThreadThatIsBeingStoppedCanStillSendAndClose() throws Exception {
        try (Pty pty = Pty.open();
                Peer peer = Peer.listening(pty)) {
            Link link = open(pty, new Listener());
            Thread.currentThread().interrupt();
            link.send(COMMAND);
            link.close();
            assertThat(Thread.interrupted())
                    .as("the thread is still marked as interrupted")
                    .isTrue();
            assertThat(peer.awaitHeard(COMMAND.length)).isEqualTo(COMMAND);
            SerialLeaks.awaitNoThreads();
        }
    }

    @Test
    void whatCameBeforeOpenIsDropped() throws Exception {
        Listener listener = new Listener();
        try (Pty pty = Pty.open();
                RandomAccessFile earlierClient =
                        new RandomAccessFile(pty.slavePath().toFile(), "rw")) {
            assertThat(earlierClient.getFD().valid()).isTrue();
            assertThat(pty.write(new byte[] {1, 2, 3}, 3)).isEqualTo(3);
            try (Link link = open(pty, listener)) {
                assertThat(pty.write(new byte[] {4, 5}, 2)).isEqualTo(2);
                assertThat(listener.awaitReceived(2)).containsExactly(4, 5);
                assertThat(link.description()).isEqualTo("serial port " + pty.path() + " at 115200 baud");
            }
        }
    }

    @Test
    void theBaudRateReachesThePort() throws Exception {
        int[] everyRateOfTheOpenInterface = {
            300, 600, 1_200, 2_400, 4_800, 9_600, 14_400, 19_200, 28_800, 38_400, 57_600, 115_200
        };
        try (Pty pty = Pty.open()) {
            for (int baud : everyRateOfTheOpenInterface) {
                try (Link link = SerialLink.open(settings(pty).withBaud(baud))) {
                    assertThat(link.loss()).isNull();
                    assertThat(pty.clientBaud()).isEqualTo(baud);
                }
            }
        }
    }

    @Test
    void aTerminalHasNoWakeLine() throws Exception {
        try (Pty pty = Pty.open()) {
            for (WakeSignal signal : WakeSignal.values()) {
                Link link = SerialLink.open(settings(pty).withWakeSignal(signal));
                WakeLine wakeLine = link.wakeLine();
                assertThat(wakeLine.setLow(true)).isFalse();
                assertThat(wakeLine.setLow(false)).isFalse();
                link.close();
                assertThat(wakeLine.setLow(true)).as("after close").isFalse();
            }
        }
    }

    @Test
    void theReceivingThreadMayCloseTheLink() throws Exception {
        CompletableFuture<Boolean> closed = new CompletableFuture<>();
        try (Pty pty = Pty.open()) {
            Link link = SerialLink.open(settings(pty));
            Listener closing = new Listener() {
                @Override
                synchronized void received(byte[] buffer, int length) {
                    link.close();
                    closed.complete(true);
                }
            };
            closing.listenTo(link);
            pty.write(COMMAND, COMMAND.length);
            assertThat(closed.get(Listener.PATIENCE_SECONDS, TimeUnit.SECONDS)).isTrue();
            link.close();
            assertThat(closing.isLost()).as("closing is no loss").isFalse();
            SerialLeaks.awaitNoThreads();
        }
    }

    @Test
    void closingALinkThatIsNotReadReleasesIt() throws Exception {
        try (Pty pty = Pty.open()) {
            Link link = SerialLink.open(settings(pty));
            link.send(COMMAND);
            link.close();
            assertThat(link.receive(new byte[1])).isEqualTo(Link.ENDED);
            assertThat(link.loss()).isNull();
            assertThat(pty.clientPresent()).isFalse();
            SerialLeaks.awaitNoThreads();
        }
    }

    @Test
    void aClosedLinkSendsNothing() throws Exception {
        try (Pty pty = Pty.open()) {
            Link link = open(pty, new Listener());
            link.close();
            link.close();
            assertThatThrownBy(() -> link.send(COMMAND))
                    .hasMessage(link.description() + " is not open")
                    .isInstanceOfSatisfying(
                            LinkException.class,
                            failure -> assertThat(failure.fault()).isEqualTo(Fault.CLOSED));
        }
    }

    private static SerialSettings settings(Pty pty) {
        return new SerialSettings(pty.path().toString());
    }

    private static Link open(Pty pty, Listener listener) {
        return listener.listenTo(SerialLink.open(settings(pty)));
    }
}
