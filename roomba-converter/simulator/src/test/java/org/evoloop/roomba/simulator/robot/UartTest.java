package org.evoloop.roomba.simulator.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.quicktheories.QuickTheory.qt;
import static org.quicktheories.generators.SourceDSL.integers;
import static org.quicktheories.generators.SourceDSL.longs;

import java.util.Random;
import org.junit.jupiter.api.Test;

class UartTest {
    private static byte[] read(int sentBaud, int readBaud, int... octets) {
        byte[] sent = new byte[octets.length];
        for (int i = 0; i < octets.length; i++) {
            sent[i] = (byte) octets[i];
        }
        return Uart.read(sent, sent.length, sentBaud, readBaud);
    }

    @Test
    void atNearlyTheSameRateEveryByteIsRead() {
        qt().forAll(longs().all(), integers().between(1, 100), integers().between(9_700, 10_300))
                .checkAssert((seed, length, readBaud) -> {
                    byte[] sent = new byte[length];
                    new Random(seed).nextBytes(sent);
                    assertThat(Uart.read(sent, length, 10_000, readBaud)).isEqualTo(sent);
                });
    }

    @Test
    void aSlowReaderTakesAFastByteForOneLowBitAtMost() {
        // Ten bits at 115200 are over before the second bit at 19200 is sampled.
        assertThat(read(115_200, 19_200, 128)).containsExactly(0xFF);
        assertThat(read(115_200, 19_200, 0)).containsExactly(0xFF);
        assertThat(read(115_200, 19_200, 255)).containsExactly(0xFF);
    }

    @Test
    void aFastReaderSeesEachLowBitOfASlowByteAsOneOfItsOwn() {
        // Six times as fast: the start bit alone is read as a start bit and five low bits.
        assertThat(read(19_200, 115_200, 255)).containsExactly(0xE0);
        // Start bit and eight low bits without a stop bit: one byte, then it waits for the line to go high.
        assertThat(read(19_200, 115_200, 0)).containsExactly(0x00);
        assertThat(read(19_200, 115_200, 0b01010101)).containsExactly(0xE0, 0xE0, 0xE0, 0xE0, 0xE0);
    }

    @Test
    void nothingSentIsNothingRead() {
        assertThat(read(19_200, 115_200)).isEmpty();
    }
}
