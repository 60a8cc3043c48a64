package org.evoloop.journal;

import java.nio.ByteBuffer;
import java.util.UUID;

/**
 * Which segment of which journal a file is, and what came before it.
 *
 * @param journal the journal's identity, chosen at random when its first segment begins
 * @param number its number, from 1
 * @param oldest the oldest segment that was kept when it began; earlier ones may be missing
 * @param before where the segment before it ended
 * @param bytes the size of its file while it is written
 */
record Place(UUID journal, long number, long oldest, Link before, int bytes) {
    static final int BYTES = 48;

    /**
     * The end of a segment.
     *
     * @param end the end of its last record in the file, in bytes; 0 if there is no segment
     * @param sum the {@linkplain Frame#sum sum} of its records, and of its place
     */
    record Link(int end, long sum) {
        static final Link NONE = new Link(0, 0);

        @Override
        public String toString() {
            return "byte " + end + ", sum " + String.format("%016x", sum);
        }
    }

    /** Its name in messages. */
    String journalName() {
        return journal.toString().substring(0, 8);
    }

    void write(ByteBuffer file, int at) {
        file.putLong(at, journal.getMostSignificantBits());
        file.putLong(at + 8, journal.getLeastSignificantBits());
        file.putLong(at + 16, number);
        file.putLong(at + 24, oldest);
        file.putLong(at + 32, before.sum());
        file.putInt(at + 40, before.end());
        file.putInt(at + 44, bytes);
    }

    static Place read(ByteBuffer file, int at) {
        return new Place(
                new UUID(file.getLong(at), file.getLong(at + 8)),
                file.getLong(at + 16),
                file.getLong(at + 24),
                new Link(file.getInt(at + 40), file.getLong(at + 32)),
                file.getInt(at + 44));
    }

    int crc() {
        byte[] written = new byte[BYTES];
        write(ByteBuffer.wrap(written), 0);
        return Frame.crcOf(written, 0, BYTES);
    }
}
