package org.evoloop.journal;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SegmentTest {
    private static final int BYTES = 1 << 20;

    @TempDir
    private Path directory;

    /** Forcing touches the place where records are being written. */
    @Test
    void forcingChangesNoRecordThatIsBeingWritten() throws IOException, InterruptedException {
        Segment segment = new Segment(directory.resolve("segment"), BYTES);
        AtomicBoolean full = new AtomicBoolean();
        Thread forcing = new Thread(() -> {
            while (!full.get()) {
                segment.force();
            }
            segment.force();
        });
        forcing.start();
        Random lengths = new Random(1);
        int count = 0;
        while (segment.append(record(count, lengths), length(count))) {
            count++;
        }
        full.set(true);
        forcing.join();
        segment.close();

        Random again = new Random(1);
        List<byte[]> written = payloads(segment);
        assertThat(written).hasSize(count);
        for (int number = 0; number < count; number++) {
            assertThat(written.get(number)).as("record %d", number).isEqualTo(record(number, again));
        }
    }

    @Test
    void aShortRecordHasTheSameChecksumAsALongOne() {
        Random random = new Random(2);
        for (int length = 0; length <= Frame.SHORT_BYTES; length++) {
            byte[] bytes = new byte[length];
            random.nextBytes(bytes);
            assertThat(Frame.crcOfShort(bytes, length)).isEqualTo(Frame.crcOf(bytes, 0, length));
        }
    }

    @Test
    void shortAndLongRecordsAreWrittenAsTheyAre() throws IOException {
        Segment segment = new Segment(directory.resolve("segment"), BYTES);
        List<byte[]> records = new ArrayList<>();
        Random random = new Random(3);
        for (int length = Frame.SHORT_BYTES - 9; length < Frame.SHORT_BYTES + 9; length++) {
            byte[] record = new byte[length];
            random.nextBytes(record);
            records.add(record);
            assertThat(segment.append(record, length)).isTrue();
        }
        segment.close();

        assertThat(payloads(segment)).containsExactly(records.toArray(byte[][]::new));
    }

    /** The payloads in a closed segment; their checksums are right. */
    private static List<byte[]> payloads(Segment segment) throws IOException {
        ByteBuffer file = ByteBuffer.wrap(Files.readAllBytes(segment.file()));
        List<byte[]> payloads = new ArrayList<>();
        int at = Preamble.BYTES;
        while (at < file.capacity()) {
            long header = file.getLong(at);
            byte[] payload = new byte[Frame.length(header)];
            file.get(at + Frame.HEADER_BYTES, payload);
            assertThat(Frame.crc(header)).isEqualTo(Frame.crcOf(payload, 0, payload.length));
            payloads.add(payload);
            at += Frame.HEADER_BYTES + Frame.padded(payload.length);
        }
        return payloads;
    }

    private static byte[] record(int number, Random random) {
        byte[] record = new byte[length(number)];
        random.nextBytes(record);
        return record;
    }

    private static int length(int number) {
        return 1 + number % 97;
    }
}
