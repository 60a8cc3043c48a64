package org.evoloop.roomba.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.quicktheories.QuickTheory.qt;
import static org.quicktheories.generators.SourceDSL.integers;
import static org.quicktheories.generators.SourceDSL.longs;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.evoloop.roomba.link.LinkException.Fault;
import org.evoloop.roomba.link.MemoryLink.Noise;
import org.evoloop.roomba.link.MemoryLink.Pair;
import org.junit.jupiter.api.Test;

class MemoryLinkTest {
    private final Listener converterHears = new Listener();
    private final Listener robotHears = new Listener();
    private final List<Boolean> brc = new ArrayList<>();
    private final Pair pair = MemoryLink.pair(brc::add);
    private final MemoryLink converter = pair.converter();
    private final MemoryLink robot = pair.robot();

    private void openBoth() {
        converter.open(converterHears);
        robot.open(robotHears);
    }

    @Test
    void bytesArriveBeforeTheSendReturns() {
        openBoth();
        converter.send(new byte[] {1, 2});
        assertThat(robotHears.received()).containsExactly(1, 2);
        robot.send(new byte[] {3});
        assertThat(converterHears.received()).containsExactly(3);
    }

    @Test
    void aReplyFromWithinTheReceiverNeverEntersAReceiverTwice() {
        List<String> order = new ArrayList<>();
        converter.open(new Listener() {
            @Override
            public synchronized void received(byte[] buffer, int length) {
                order.add("converter hears " + buffer[0]);
                if (buffer[0] < 4) {
                    converter.send(new byte[] {(byte) (buffer[0] + 1)});
                }
                order.add("converter is done with " + buffer[0]);
            }
        });
        robot.open(new Listener() {
            @Override
            public synchronized void received(byte[] buffer, int length) {
                order.add("robot hears " + buffer[0]);
                robot.send(new byte[] {(byte) (buffer[0] + 1)});
                order.add("robot is done with " + buffer[0]);
            }
        });
        converter.send(new byte[] {1});
        assertThat(order)
                .containsExactly(
                        "robot hears 1",
                        "robot is done with 1",
                        "converter hears 2",
                        "converter is done with 2",
                        "robot hears 3",
                        "robot is done with 3",
                        "converter hears 4",
                        "converter is done with 4");
    }

    @Test
    void bytesForAnEndThatIsNotOpenAreLost() {
        converter.open(converterHears);
        converter.send(new byte[] {1});
        robot.open(robotHears);
        converter.send(new byte[] {2});
        robot.close();
        converter.send(new byte[] {3});
        assertThat(robotHears.received()).containsExactly(2);
        assertThat(robotHears.isLost()).isFalse();
    }

    @Test
    void hangingUpIsToldOnceAtBothEnds() throws Exception {
        openBoth();
        converter.hangUp();
        robot.hangUp();
        assertThat(converterHears.awaitLost().fault()).isEqualTo(Fault.HUNG_UP);
        assertThat(robotHears.awaitLost().fault()).isEqualTo(Fault.HUNG_UP);
        assertFault(Fault.HUNG_UP, () -> converter.send(new byte[1]));
    }

    @Test
    void sendingToAnEndThatDoesNotReadLosesTheLink() throws Exception {
        openBoth();
        robot.setReading(false);
        assertFault(Fault.NOT_READING, () -> converter.send(new byte[1]));
        assertThat(converterHears.awaitLost().fault()).isEqualTo(Fault.NOT_READING);
        assertThat(robotHears.isLost()).isFalse();
        assertThat(robotHears.received()).isEmpty();
    }

    @Test
    void onlyAnOpenLinkSendsAndMovesTheWakeLine() {
        assertFault(Fault.CLOSED, () -> converter.send(new byte[1]));
        assertThat(converter.wakeLine().setLow(true)).isFalse();
        openBoth();
        assertThat(converter.wakeLine().setLow(true)).isTrue();
        assertThat(converter.wakeLine().setLow(false)).isTrue();
        assertThat(robot.wakeLine().setLow(true)).isFalse();
        converter.close();
        converter.close();
        assertFault(Fault.CLOSED, () -> converter.send(new byte[1]));
        assertThat(converter.wakeLine().setLow(true)).isFalse();
        assertThatThrownBy(() -> converter.open(converterHears)).isInstanceOf(IllegalStateException.class);
        assertThat(brc).containsExactly(true, false);
    }

    @Test
    void noiseIsTheSameForTheSameSeed() {
        qt().forAll(longs().all(), integers().between(0, 100), integers().between(0, 100))
                .check((seed, dropPercent, corruptPercent) -> {
                    Noise noise = new Noise(seed, dropPercent / 100.0, corruptPercent / 100.0);
                    byte[] first = throughNoise(noise);
                    byte[] second = throughNoise(noise);
                    return Arrays.equals(first, second) && first.length <= 500;
                });
    }

    @Test
    void noiseDropsAndCorruptsAtItsRates() {
        assertThat(throughNoise(new Noise(1, 0, 0))).isEqualTo(noisy());
        assertThat(throughNoise(new Noise(1, 1, 0))).isEmpty();
        byte[] corrupted = throughNoise(new Noise(1, 0, 1));
        for (int i = 0; i < corrupted.length; i++) {
            assertThat(Integer.bitCount((corrupted[i] ^ noisy()[i]) & 0xFF)).isEqualTo(1);
        }
        assertThat(throughNoise(new Noise(1, 0.5, 0)).length).isBetween(200, 300);
    }

    private static byte[] throughNoise(Noise noise) {
        Pair noisyPair = MemoryLink.pair();
        Listener listener = new Listener();
        noisyPair.converter().open(new Listener());
        noisyPair.robot().open(listener);
        noisyPair.converter().setNoise(noise);
        noisyPair.converter().send(noisy());
        return listener.received();
    }

    private static byte[] noisy() {
        byte[] bytes = new byte[500];
        new Random(7).nextBytes(bytes);
        return bytes;
    }

    private static void assertFault(Fault fault, Runnable call) {
        assertThatThrownBy(call::run)
                .isInstanceOfSatisfying(
                        LinkException.class,
                        failure -> assertThat(failure.fault()).isEqualTo(fault));
    }
}
