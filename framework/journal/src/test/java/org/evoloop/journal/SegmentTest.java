package org.evoloop.journal;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
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

        ByteBuffer file = ByteBuffer.wrap(Files.readAllBytes(segment.file()));
        Random again = new Random(1);
        int at = Preamble.BYTES;
        for (int number = 0; number < count; number++) {
            long header = file.getLong(at);
            byte[] payload = new byte[Frame.length(header)];
            file.get(at + Frame.HEADER_BYTES, payload);
            assertThat(payload).as("record %d", number).isEqualTo(record(number, again));
            assertThat(Frame.crc(header)).isEqualTo(Frame.crcOf(payload, 0, payload.length));
            at += Frame.HEADER_BYTES + Frame.padded(payload.length);
        }
        assertThat(at).isEqualTo(file.capacity());
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
