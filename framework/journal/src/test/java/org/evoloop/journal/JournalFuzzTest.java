package org.evoloop.journal;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.evoloop.engine.Input;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Whatever the bytes of a segment are, a converter continues from it or refuses it with a message that names the file.
 */
@Timeout(30)
class JournalFuzzTest {
    private static final byte[] WHOLE = segment();
    private static final byte[] OPEN = open();
    private static final int FIRST_RECORD = firstRecord();
    private static final Path FILE = file();

    private static Path file() {
        try {
            Path file = Files.createTempFile("evoloop-fuzz", ".segment");
            file.toFile().deleteOnExit();
            return file;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static byte[] segment() {
        try {
            Path directory = Files.createTempDirectory("evoloop-fuzz");
            try (JournaledCore kept = JournaledCore.in(directory)) {
                List<Input> story = Story.of(Robot.RULES, new Random(3), 40);
                kept.input(story);
            }
            Path only = Directory.segments(directory).get(0);
            byte[] bytes = Files.readAllBytes(only);
            for (Path file : List.copyOf(Directory.segments(directory))) {
                Files.delete(file);
            }
            return bytes;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** As a killed process leaves it, but for the unused room. */
    private static byte[] open() {
        byte[] bytes = WHOLE.clone();
        Arrays.fill(bytes, 88, Preamble.BYTES, (byte) 0);
        return bytes;
    }

    private static int firstRecord() {
        try {
            Path copy = file();
            Files.write(copy, WHOLE);
            SegmentReader reader = new SegmentReader(copy);
            Files.delete(copy);
            return reader.end();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void recover(byte[] bytes) throws IOException {
        Files.write(FILE, bytes);
        try {
            Replay replay = new Replay(Robot.RULES, Fingerprint.of(Robot.MODELS), new JournaledCore.Forgetting());
            replay.of(List.of(FILE));
            assertThat(replay.result(new ManualClock())).isNotNull();
        } catch (JournalException refused) {
            assertThat(refused).hasMessageStartingWith(FILE.toString());
        }
    }

    @MethodSource("segments")
    @FuzzTest
    void aSegmentOfAnyBytesIsContinuedOrRefused(byte[] bytes) throws IOException {
        if (bytes.length >= Preamble.BYTES) {
            recover(bytes);
        }
    }

    /** Records with correct checksums, as a faulty or hostile program might write them. */
    @MethodSource("records")
    @FuzzTest
    void recordsOfAnyBytesAreContinuedOrRefused(byte[] bytes) throws IOException {
        ByteArrayOutputStream segment = new ByteArrayOutputStream();
        segment.write(OPEN, 0, FIRST_RECORD);
        int from = 0;
        while (from < bytes.length) {
            int length = Math.min(bytes[from] & 0xFF, bytes.length - from - 1);
            segment.write(framed(bytes, from + 1, length));
            from += length + 1;
        }
        byte[] written = segment.toByteArray();
        Place place = Preamble.of(FILE, OPEN).place();
        Preamble.write(
                ByteBuffer.wrap(written),
                new Place(place.journal(), place.number(), place.oldest(), place.before(), written.length));
        recover(written);
    }

    private static byte[] framed(byte[] bytes, int from, int length) {
        return ByteBuffer.allocate(Frame.HEADER_BYTES + Frame.padded(length))
                .putLong(Frame.header(length, Frame.crcOf(bytes, from, length)))
                .put(bytes, from, length)
                .array();
    }

    static List<byte[]> segments() {
        return List.of(WHOLE, Arrays.copyOf(WHOLE, FIRST_RECORD), Arrays.copyOf(WHOLE, WHOLE.length - 3));
    }

    /** The records of the story, all at once and one by one. */
    static List<byte[]> records() {
        List<byte[]> records = new ArrayList<>();
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        int next = FIRST_RECORD;
        while (next + Frame.HEADER_BYTES < WHOLE.length) {
            int length = Frame.length(ByteBuffer.wrap(WHOLE).getLong(next));
            ByteArrayOutputStream one = new ByteArrayOutputStream();
            one.write(length);
            one.write(WHOLE, next + Frame.HEADER_BYTES, length);
            records.add(one.toByteArray());
            all.writeBytes(one.toByteArray());
            next += Frame.HEADER_BYTES + Frame.padded(length);
        }
        records.add(all.toByteArray());
        return records;
    }
}
