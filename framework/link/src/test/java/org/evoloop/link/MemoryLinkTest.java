package org.evoloop.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.quicktheories.QuickTheory.qt;
import static org.quicktheories.generators.SourceDSL.integers;
import static org.quicktheories.generators.SourceDSL.longs;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.evoloop.link.LinkException.Fault;
import org.evoloop.link.MemoryLink.Noise;
import org.evoloop.link.MemoryLink.Pair;
import org.junit.jupiter.api.Test;

class MemoryLinkTest {
    private final Listener converterHears = new Listener();
    private final Listener deviceHears = new Listener();
    private final List<Boolean> brc = new ArrayList<>();
    private final Pair pair = MemoryLink.pair(brc::add);
    private final MemoryLink converter = pair.converter();
    private final MemoryLink device = pair.device();

    private void readBoth() {
        converterHears.read(converter);
        deviceHears.read(device);
    }

    @Test
    void bytesHaveArrivedWhenTheSendReturns() {
        converter.send(new byte[] {1, 2});
        deviceHears.read(device);
        assertThat(deviceHears.received()).containsExactly(1, 2);
        device.send(new byte[] {3});
        converterHears.read(converter);
        assertThat(converterHears.received()).containsExactly(3);
    }

    @Test
    void aSmallBufferTakesThemPieceByPieceWithoutWaiting() {
        converter.send(new byte[] {1, 2, 3});
        converter.send(new byte[] {4});
        byte[] buffer = new byte[2];
        assertThat(device.receive(buffer)).isEqualTo(2);
        assertThat(buffer).containsExactly(1, 2);
        assertThat(device.receive(buffer)).isEqualTo(1);
        assertThat(buffer[0]).isEqualTo((byte) 3);
        assertThat(device.receive(buffer)).isEqualTo(1);
        assertThat(buffer[0]).isEqualTo((byte) 4);
        assertThat(device.receive(buffer)).isZero();
    }

    @Test
    void bytesForAnEndThatIsClosedAreLost() {
        converter.send(new byte[] {1});
        device.close();
        converter.send(new byte[] {2});
        assertThat(device.receive(new byte[1])).isEqualTo(Link.ENDED);
        assertThat(device.loss()).isNull();
    }

    @Test
    void hangingUpIsReportedAtBothEndsAfterAllBytes() {
        device.send(new byte[] {1});
        converter.hangUp();
        device.hangUp();
        readBoth();
        assertThat(converterHears.received()).containsExactly(1);
        assertThat(converterHears.isLost()).isTrue();
        assertThat(deviceHears.isLost()).isTrue();
        assertLost(Fault.HUNG_UP, converter);
        assertLost(Fault.HUNG_UP, device);
        assertFault(Fault.HUNG_UP, () -> converter.send(new byte[1]));
    }

    @Test
    void sendingToAnEndThatDoesNotReadLosesTheLink() {
        device.setReading(false);
        assertFault(Fault.NOT_READING, () -> converter.send(new byte[1]));
        readBoth();
        assertLost(Fault.NOT_READING, converter);
        assertThat(deviceHears.isLost()).isFalse();
        assertThat(deviceHears.received()).isEmpty();
    }

    private static void assertLost(Fault fault, Link link) {
        assertThat(link.loss())
                .isInstanceOfSatisfying(
                        LinkException.class, loss -> assertThat(loss.fault()).isEqualTo(fault));
    }

    @Test
    void onlyAnOpenLinkSendsAndMovesTheWakeLine() {
        assertThat(converter.wakeLine().setLow(true)).isTrue();
        assertThat(converter.wakeLine().setLow(false)).isTrue();
        assertThat(device.wakeLine().setLow(true)).isFalse();
        converter.close();
        converter.close();
        assertFault(Fault.CLOSED, () -> converter.send(new byte[1]));
        assertThat(converter.wakeLine().setLow(true)).isFalse();
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
        noisyPair.converter().setNoise(noise);
        noisyPair.converter().send(noisy());
        listener.read(noisyPair.device());
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
