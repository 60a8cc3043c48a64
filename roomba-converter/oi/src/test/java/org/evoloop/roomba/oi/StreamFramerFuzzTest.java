package org.evoloop.roomba.oi;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.ToIntFunction;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Compares the framer with a plain scan of all bytes: if no complete valid frame starts at a position, the search
 * continues one byte later. The noise is misleading: truncated, corrupted and complete frames, headers, ids and text.
 */
class StreamFramerFuzzTest {
    private static final List<Packet> PACKETS = List.of(Packet.BUMPS_AND_WHEEL_DROPS, Packet.CURRENT, Packet.OI_MODE);

    /** Longer than any candidate, so that nothing is left undecided at the end. */
    private static final int FLUSH = 300;

    private record Found(int end, SensorValues values) {}

    @ParameterizedTest
    @ValueSource(longs = {1, 22, 333, 4444, 55555})
    void givenPacketsAreFoundExactlyWhereThePlainScanFindsThemAndWithTheirLastByte(long seed) {
        byte[] bytes = misleading(new Random(seed), 200_000);
        List<Found> expected = plainScan(bytes, true);
        List<Found> found = feedOneByOne(bytes, new StreamFramer(PACKETS));
        assertThat(expected).as("seed %d", seed).hasSizeGreaterThan(1000);
        assertThat(found).as("seed %d", seed).isEqualTo(expected);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 22, 333, 4444, 55555})
    void anyPacketsAreFoundWhereThePlainScanFindsThemAndAtMost252BytesLater(long seed) {
        byte[] bytes = misleading(new Random(seed), 200_000);
        List<Found> expected = plainScan(bytes, false);
        List<Found> found = feedOneByOne(bytes, StreamFramer.forAnyPackets());
        assertThat(expected).as("seed %d", seed).hasSizeGreaterThan(1000);
        assertThat(found)
                .as("seed %d", seed)
                .extracting(Found::values)
                .isEqualTo(expected.stream().map(Found::values).toList());
        for (int i = 0; i < found.size(); i++) {
            assertThat(found.get(i).end() - expected.get(i).end())
                    .as("seed %d, frame %d", seed, i)
                    .isBetween(0, 252);
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {7, 77})
    void aMillionRandomBytesNeitherThrowNorStallAndAreAllAccountedFor(long seed) {
        byte[] noise = Feeding.noise(new Random(seed), 1_000_000);
        StreamFramer framer = new StreamFramer(PACKETS);
        List<SensorValues> found = new ArrayList<>(framer.feed(noise, 0, noise.length));
        byte[] good = StreamFrame.encode(PACKETS, packet -> 0);
        found.addAll(framer.feed(good, 0, good.length));
        assertThat(found).as("seed %d", seed).isNotEmpty();
        assertThat(framer.frames()).as("seed %d", seed).isEqualTo(found.size());
        assertThat(framer.skippedBytes() + framer.frames() * good.length)
                .as("seed %d", seed)
                .isEqualTo(noise.length + good.length);
    }

    private static List<Found> feedOneByOne(byte[] bytes, StreamFramer framer) {
        List<Found> found = new ArrayList<>();
        for (int at = 0; at < bytes.length; at++) {
            for (SensorValues values : framer.feed(bytes, at, 1)) {
                found.add(new Found(at + 1, values));
            }
        }
        return found;
    }

    private static byte[] misleading(Random random, int length) {
        List<byte[]> parts = new ArrayList<>();
        for (int total = 0; total < length; total += parts.get(parts.size() - 1).length) {
            parts.add(part(random));
        }
        parts.add(new byte[FLUSH]);
        return Feeding.join(parts.toArray(byte[][]::new));
    }

    private static byte[] part(Random random) {
        ToIntFunction<Packet> source = packet -> random.nextBoolean() ? 19 : random.nextInt(128);
        byte[] frame = StreamFrame.encode(PACKETS, source);
        int at = random.nextInt(frame.length);
        return switch (random.nextInt(6)) {
            case 0 -> Arrays.copyOf(frame, at);
            case 1 -> {
                frame[at] = (byte) random.nextInt();
                yield frame;
            }
            case 2 -> Feeding.octets(19, random.nextInt(256), random.nextInt(59));
            case 3 -> Feeding.noise(random, random.nextInt(20));
            case 4 -> StreamFrame.encode(List.of(PacketGroup.GROUP_100), source);
            default -> frame;
        };
    }

    private static List<Found> plainScan(byte[] bytes, boolean givenOnly) {
        List<Found> found = new ArrayList<>();
        int start = 0;
        while (start + 3 <= bytes.length) {
            List<PacketId> packets = packetsOfFrameAt(bytes, start);
            if (packets.isEmpty() || (givenOnly && !packets.equals(PACKETS))) {
                start++;
            } else {
                int end = start + StreamFrame.length(packets);
                found.add(new Found(end, SensorValues.decode(packets, dataOf(packets, bytes, start))));
                start = end;
            }
        }
        return found;
    }

    /** The packets of the complete valid frame that starts here; none if there is no such frame. */
    private static List<PacketId> packetsOfFrameAt(byte[] bytes, int start) {
        int checksumAt = start + 2 + (bytes[start + 1] & 0xFF);
        if (bytes[start] != 19 || checksumAt >= bytes.length) {
            return List.of();
        }
        int sum = 0;
        for (int i = start; i <= checksumAt; i++) {
            sum += bytes[i];
        }
        List<PacketId> packets = new ArrayList<>();
        int at = start + 2;
        while (at < checksumAt && PacketId.of(bytes[at] & 0xFF).isPresent()) {
            packets.add(PacketId.of(bytes[at] & 0xFF).orElseThrow());
            at += 1 + packets.get(packets.size() - 1).size();
        }
        return at == checksumAt && (sum & 0xFF) == 0 ? packets : List.of();
    }

    private static byte[] dataOf(List<PacketId> packets, byte[] bytes, int start) {
        ByteArrayOutputStream data = new ByteArrayOutputStream();
        int at = start + 2;
        for (PacketId packet : packets) {
            data.write(bytes, at + 1, packet.size());
            at += 1 + packet.size();
        }
        return data.toByteArray();
    }
}
