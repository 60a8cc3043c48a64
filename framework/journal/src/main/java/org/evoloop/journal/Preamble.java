package org.evoloop.journal;

import java.nio.ByteBuffer;
import java.nio.file.Path;

/**
 * The beginning of a segment: a magic number, the version of its format, a checksum of both, and, twice, up to where it
 * is certainly on the disk. It is written after the first records, so a segment with a preamble has those.
 */
final class Preamble {
    static final int BYTES = 32;

    /** The version of the format, and of the core's rules: other rules may give other outputs for the same inputs. */
    static final int VERSION = 9;

    private static final long MAGIC = 0x45564F4C4F4F504AL; // EVOLOOPJ
    private static final int CHECKED_BYTES = 12;
    private static final int SURE = 16;

    private Preamble() {}

    static void write(ByteBuffer file) {
        file.putInt(8, VERSION);
        file.putInt(CHECKED_BYTES, crcOf(VERSION));
        Frame.finish(file, 0, MAGIC);
    }

    static void sure(ByteBuffer file, int until) {
        file.putLong(SURE, until);
        file.putLong(SURE + 8, ~(long) until);
    }

    /** Whether nothing has been written there. */
    static boolean isBlank(byte[] file) {
        return file.length < BYTES || ByteBuffer.wrap(file).getLong(0) == 0;
    }

    /** @throws JournalException if the file with these bytes cannot be read */
    static void require(Path file, byte[] content) {
        if (content.length < BYTES) {
            throw JournalException.ofDamage(file + ", byte " + content.length + ": it ends too early");
        }
        ByteBuffer bytes = ByteBuffer.wrap(content);
        int version = bytes.getInt(8);
        if (bytes.getLong(0) != MAGIC) {
            throw new JournalException(
                    file + ", byte 0: this is not a segment of a journal; move the file out of the directory");
        }
        if (bytes.getInt(CHECKED_BYTES) != crcOf(version)) {
            throw JournalException.ofDamage(file + ", byte 8: the version does not match its checksum");
        }
        if (version != VERSION) {
            throw new JournalException(file + ", byte 8: it is written in version " + version
                    + " of the format, and this Evoloop reads version " + VERSION
                    + "; use the version of Evoloop that wrote it, or start with an empty directory");
        }
    }

    /** Up to where the file is certainly on the disk; if the two copies disagree, one was being written. */
    static long sure(byte[] file) {
        ByteBuffer bytes = ByteBuffer.wrap(file);
        long until = bytes.getLong(SURE);
        return until == ~bytes.getLong(SURE + 8) ? until : 0;
    }

    private static int crcOf(int version) {
        byte[] checked = ByteBuffer.allocate(CHECKED_BYTES)
                .putLong(MAGIC)
                .putInt(version)
                .array();
        return Frame.crcOf(checked, 0, CHECKED_BYTES);
    }
}
