package org.evoloop.roomba.oi;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.evoloop.roomba.oi.Feeding.join;
import static org.evoloop.roomba.oi.Feeding.octets;
import static org.quicktheories.QuickTheory.qt;
import static org.quicktheories.generators.SourceDSL.integers;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.evoloop.roomba.oi.StreamFrame.Checksum;
import org.junit.jupiter.api.Test;

class StreamFramerTest {
    private static final List<Packet> PACKETS =
            List.of(Packet.BUMPS_AND_WHEEL_DROPS, Packet.BUTTONS, Packet.CURRENT, Packet.OI_MODE, Packet.LEFT_ENCODER);
    private static final SensorValues FIRST = values(1);
    private static final SensorValues SECOND = values(2);
    private static final SensorValues THIRD = values(3);

    private final List<SensorValues> frames = new ArrayList<>();
    private final StreamFramer framer = new StreamFramer(PACKETS);

    /** Data full of headers: 19 in every byte that allows it. */
    private static SensorValues values(int mode) {
        return SensorValues.of(PACKETS, packet -> packet == Packet.OI_MODE ? mode : packet.size() == 2 ? 0x1313 : 0x13);
    }

    private static byte[] frame(SensorValues values) {
        return StreamFrame.encode(PACKETS, values::value);
    }

    private void feed(byte[]... parts) {
        byte[] bytes = join(parts);
        frames.addAll(framer.feed(bytes, 0, bytes.length));
    }

    @Test
    void anyFrameIsReadAsItWasWritten() {
        qt().withExamples(500)
                .forAll(
                        RandomCommands.streamable().assuming(packets -> !packets.isEmpty()),
                        integers().all())
                .checkAssert((packets, seed) -> {
                    byte[] data = Feeding.noise(new Random(seed), PacketId.size(packets));
                    SensorValues values = SensorValues.decode(packets, data);
                    byte[] frame = StreamFrame.encode(packets, values::value);
                    assertThat(frame).hasSize(StreamFrame.length(packets));
                    List<SensorValues> read = new ArrayList<>();
                    read.addAll(new StreamFramer(packets).feed(frame, 0, frame.length));
                    read.addAll(StreamFramer.forAnyPackets().feed(frame, 0, frame.length));
                    assertThat(read).containsExactly(values, values);
                });
    }

    @Test
    void headersInTheDataDoNotDisturb() {
        feed(frame(FIRST), frame(SECOND), frame(THIRD));
        assertThat(frames).containsExactly(FIRST, SECOND, THIRD);
        assertThat(framer.frames()).isEqualTo(3);
        assertThat(framer.skippedBytes()).isZero();
        assertThat(framer.badChecksums()).isZero();
    }

    @Test
    void bytesCountedFromTheMiddleOfAFrameOnFindTheNextOne() {
        byte[] cut = Arrays.copyOfRange(frame(FIRST), 3, frame(FIRST).length);
        feed(cut, frame(SECOND));
        assertThat(frames).containsExactly(SECOND);
        assertThat(framer.skippedBytes()).isEqualTo(cut.length);
    }

    @Test
    void frameThatIsCutAnywhereCostsOnlyItself() {
        for (int kept = 0; kept < frame(SECOND).length; kept++) {
            frames.clear();
            feed(frame(FIRST), Arrays.copyOf(frame(SECOND), kept), frame(THIRD));
            assertThat(frames).as("second frame cut after %d bytes", kept).containsExactly(FIRST, THIRD);
        }
    }

    @Test
    void frameWithAnyByteWrongCostsOnlyItself() {
        for (int position = 0; position < frame(SECOND).length; position++) {
            for (int flip = 1; flip < 256; flip++) {
                byte[] wrong = frame(SECOND);
                wrong[position] ^= (byte) flip;
                frames.clear();
                feed(frame(FIRST), wrong, frame(THIRD));
                assertThat(frames)
                        .as("byte %d of the second frame xor %d", position, flip)
                        .containsExactly(FIRST, THIRD);
            }
        }
    }

    @Test
    void byteTooManyAnywhereCostsAtMostThatFrame() {
        byte[] second = frame(SECOND);
        for (int position = 0; position <= second.length; position++) {
            for (int octet = 0; octet < 256; octet++) {
                frames.clear();
                feed(
                        frame(FIRST),
                        Arrays.copyOf(second, position),
                        octets(octet),
                        Arrays.copyOfRange(second, position, second.length),
                        frame(THIRD));
                assertThat(frames)
                        .as("byte %d inserted at %d", octet, position)
                        .startsWith(FIRST)
                        .endsWith(THIRD)
                        .hasSizeBetween(2, 3);
            }
        }
    }

    @Test
    void bootTextAndChargingLinesBetweenFramesAreSkipped() {
        byte[] boot = "Soft reset!\r\n\u00feRoomba by iRobot!\r\nstm32\r\n".getBytes(StandardCharsets.ISO_8859_1);
        byte[] charging = "bat:   min 0  sec 10  mV 17061  mA 1016  tenths-deg-C 348  mAH 2696  state 5  \r\n"
                .getBytes(StandardCharsets.ISO_8859_1);
        feed(boot, frame(FIRST), charging, frame(SECOND), charging, boot, frame(THIRD));
        assertThat(frames).containsExactly(FIRST, SECOND, THIRD);
        assertThat(framer.skippedBytes()).isEqualTo(2L * boot.length + 2L * charging.length);
    }

    @Test
    void checksumWithoutHeaderIsRejectedAndCounted() {
        feed(StreamFrame.encode(PACKETS, FIRST::value, Checksum.WITHOUT_HEADER), frame(SECOND));
        assertThat(frames).containsExactly(SECOND);
        assertThat(framer.badChecksums()).isEqualTo(1);
    }

    @Test
    void framesOfAnotherStreamAreSkipped() {
        List<Packet> others = List.of(Packet.WALL, Packet.VOLTAGE);
        feed(StreamFrame.encode(others, packet -> 1), frame(FIRST));
        assertThat(frames).containsExactly(FIRST);
    }

    @Test
    void frameIsDeliveredWithItsLastByteEvenBehindAHeaderAndLengthThatLie() {
        byte[] good = frame(FIRST);
        feed(Arrays.copyOf(good, 3), Arrays.copyOf(good, good.length - 1));
        assertThat(frames).isEmpty();
        feed(octets(good[good.length - 1]));
        assertThat(frames).containsExactly(FIRST);
    }

    @Test
    void aWrongLengthDelaysAnyPacketsNoLongerThanPromised() {
        // A header that announces 255 bytes, followed by pairs of id and data: it looks valid until its end.
        StreamFramer any = StreamFramer.forAnyPackets();
        byte[] good = StreamFrame.encode(List.of(Packet.WALL), packet -> 0);
        byte[] before = octets(19, 255);
        frames.addAll(any.feed(before, 0, before.length));
        frames.addAll(any.feed(good, 0, good.length));
        int waited = 0;
        while (frames.isEmpty()) {
            frames.addAll(any.feed(octets(Packet.WALL.id()), 0, 1));
            waited++;
        }
        assertThat(waited).isBetween(1, 252);
        assertThat(frames).containsExactly(SensorValues.of(List.of(Packet.WALL), packet -> 0));
    }

    @Test
    void framesOfNoPacketsAreNotWorthDelivering() {
        byte[] empty = octets(19, 0, 237);
        frames.addAll(StreamFramer.forAnyPackets().feed(empty, 0, empty.length));
        assertThat(frames).isEmpty();
    }

    @Test
    void shouldRefusePacketsThatDoNotFitIntoAFrame() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new StreamFramer(Collections.nCopies(4, PacketGroup.GROUP_100)))
                .withMessageContaining("324 bytes");
    }
}
