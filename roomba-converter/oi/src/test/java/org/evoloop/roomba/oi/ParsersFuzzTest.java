package org.evoloop.roomba.oi;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.evoloop.roomba.oi.CommandParser.Parsed;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * No bytes may break the parsers. A normal run tries the seeds; CONTRIBUTING.md says how to let Jazzer search for more.
 */
class ParsersFuzzTest {
    private static final List<PacketId> PACKETS = List.of(Packet.BUMPS_AND_WHEEL_DROPS, Packet.CURRENT, Packet.OI_MODE);
    private static final byte[] INTACT = StreamFrame.encode(PACKETS, packet -> 7);
    private static final SensorValues INTACT_VALUES = SensorValues.of(PACKETS, packet -> 7);

    /** Longer than any unfinished frame or command. 0 is neither a header nor an opcode. */
    private static final byte[] GAP = new byte[512];

    @MethodSource("seeds")
    @FuzzTest
    void anIntactFrameIsDeliveredAfterAnyBytesAndEachByteIsAccountedFor(byte[] bytes) {
        List<SensorValues> found = new ArrayList<>();
        StreamFramer framer = new StreamFramer(PACKETS);
        byte[] all = Feeding.join(bytes, GAP, INTACT);

        feedInPieces(bytes, all, (piece, offset, count) -> found.addAll(framer.feed(piece, offset, count)));

        assertThat(found).isNotEmpty();
        assertThat(found.get(found.size() - 1)).isEqualTo(INTACT_VALUES);
        assertThat(framer.frames()).isEqualTo(found.size());
        assertThat(framer.skippedBytes() + framer.frames() * INTACT.length).isEqualTo(all.length);
    }

    @MethodSource("seeds")
    @FuzzTest
    void aFrameOfAnyPacketsIsDeliveredAfterAnyBytes(byte[] bytes) {
        List<SensorValues> found = new ArrayList<>();
        StreamFramer framer = StreamFramer.forAnyPackets();
        byte[] all = Feeding.join(bytes, GAP, INTACT);

        feedInPieces(bytes, all, (piece, offset, count) -> found.addAll(framer.feed(piece, offset, count)));

        assertThat(found).isNotEmpty();
        assertThat(found.get(found.size() - 1)).isEqualTo(INTACT_VALUES);
        assertThat(framer.frames()).isEqualTo(found.size());
        assertThat(framer.skippedBytes()).isLessThan(all.length);
    }

    @MethodSource("seeds")
    @FuzzTest
    void aCommandIsRecognisedAfterAnyBytesHoweverTheyAreCut(byte[] bytes) {
        List<Parsed> found = new ArrayList<>();
        byte[] all = Feeding.join(bytes, GAP, new Command.Start().bytes());

        feedInPieces(bytes, all, new CommandParser(found::add)::feed);

        assertThat(found.get(found.size() - 1)).isEqualTo(new Parsed.Accepted(new Command.Start()));
        assertThat(found).isEqualTo(Feeding.parse(all));
    }

    static List<byte[]> seeds() {
        byte[] cutShort = Arrays.copyOf(INTACT, 5);
        byte[] withWrongChecksum = INTACT.clone();
        withWrongChecksum[INTACT.length - 1]++;
        return List.of(
                "bl-start\r\nSTR730\r\n".getBytes(StandardCharsets.US_ASCII),
                Feeding.join(INTACT, INTACT),
                Feeding.join(cutShort, INTACT, withWrongChecksum, INTACT),
                StreamFrame.encode(List.of(PacketGroup.GROUP_100), packet -> StreamFrame.HEADER),
                Feeding.octets(StreamFrame.HEADER, 255, 0),
                Feeding.join(
                        new InputCommand.Stream(PACKETS).bytes(), new ActuatorCommand.DriveDirect(-200, 500).bytes()),
                Feeding.octets(Opcode.SONG.code(), 1, 255),
                Feeding.octets(Opcode.DRIVE.code(), 128, 0, 128, 0, 147, 7));
    }

    private interface Feed {
        void feed(byte[] bytes, int offset, int count);
    }

    /** Splits the bytes where {@code cuts} says. */
    private static void feedInPieces(byte[] cuts, byte[] bytes, Feed target) {
        int offset = 0;
        for (int piece = 0; offset < bytes.length; piece++) {
            int wanted = piece < cuts.length ? cuts[piece] & 0xFF : bytes.length;
            int count = Math.min(wanted, bytes.length - offset);
            target.feed(bytes, offset, count);
            offset += count;
        }
    }
}
