package org.evoloop.journal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.evoloop.journal.Place.Link;
import org.jspecify.annotations.Nullable;

/**
 * The beginning of a segment: a magic number and the version of its format, up to where it is certainly on the disk, its
 * place in the journal, and, once nothing more is appended, its end. It is written after the first records, so a segment
 * with a preamble has those.
 *
 * @param sure up to which byte it is certainly on the disk
 * @param ending what is known of its end
 * @param end where it ends; {@link Link#NONE} while it is open
 */
record Preamble(int sure, Place place, Ending ending, Link end) {
    static final int BYTES = 104;

    /** The version of the format, and of the core's rules: other rules may give other outputs for the same inputs. */
    static final int VERSION = 12;

    private static final long MAGIC = 0x45564F4C4F4F504AL; // EVOLOOPJ
    private static final int VERSION_AT = 8;
    private static final int VERSION_CRC_AT = 12;
    private static final int SURE_AT = 16;
    private static final int PLACE_AT = 32;
    private static final int PLACE_CRC_AT = PLACE_AT + Place.BYTES;
    private static final int SUM_AT = 88;
    private static final int ENDING_AT = 96;

    /** What a segment says of its end; the code is in the file. */
    enum Ending {
        /** It is being written, or its process was killed. */
        OPEN(0),
        /** It ends, and is the last one. */
        CLOSED(0x434C4F53),
        /** The next segment has begun, but a power cut may have taken that. */
        CONTINUED(0x434F4E54),
        /** The next segment is certainly on the disk. */
        SURELY_CONTINUED(0x53555245);

        private final int code;

        Ending(int code) {
            this.code = code;
        }

        static @Nullable Ending of(int code) {
            for (Ending each : values()) {
                if (each.code == code) {
                    return each;
                }
            }
            return null;
        }
    }

    static void write(ByteBuffer file, Place place) {
        file.putInt(VERSION_AT, VERSION);
        file.putInt(VERSION_CRC_AT, crcOf(VERSION));
        place.write(file, PLACE_AT);
        file.putInt(PLACE_CRC_AT, place.crc());
        Frame.finish(file, 0, MAGIC);
    }

    static void sure(ByteBuffer file, int until) {
        file.putLong(SURE_AT, until);
        file.putLong(SURE_AT + 8, ~(long) until);
    }

    /** Notes in the file that it ends there. */
    static void close(ByteBuffer file, Link end) {
        file.putLong(SUM_AT, end.sum());
        Frame.finish(file, ENDING_AT, ending(Ending.CLOSED, end));
    }

    /** Notes in a file that is not mapped where and how it ends. A kill cannot divide so short a write. */
    static void end(FileChannel file, Ending ending, Link end) throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate(BYTES - SUM_AT);
        bytes.putLong(end.sum()).putLong(ending(ending, end)).flip();
        file.write(bytes, SUM_AT);
    }

    /** Notes in a segment that the one after it has begun. */
    static void continued(Path file, Ending ending, Link end) throws IOException {
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE)) {
            end(channel, ending, end);
        }
    }

    private static long ending(Ending ending, Link end) {
        return (long) ending.code << 32 | end.end();
    }

    /** @throws JournalException if the file with these bytes cannot be read */
    static Preamble of(Path file, byte[] content) {
        if (content.length == 0) {
            throw JournalException.ofDamage(file, "it is empty");
        }
        if (content.length < SURE_AT) {
            throw tooShort(file, content);
        }
        ByteBuffer bytes = ByteBuffer.wrap(content);
        if (bytes.getLong(0) != MAGIC) {
            throw JournalException.ofDamage(
                    file,
                    ", byte 0: " + (bytes.getLong(0) == 0 ? "it is blank" : "it does not begin with EVOLOOPJ")
                            + ", so this is no segment of a journal, or was overwritten");
        }
        int version = bytes.getInt(VERSION_AT);
        if (bytes.getInt(VERSION_CRC_AT) != crcOf(version)) {
            throw JournalException.ofDamage(file, ", byte 8: the version does not match its checksum");
        }
        if (version != VERSION) {
            throw new JournalException(file + ", byte 8: it is written in version " + version
                    + " of the format, and this Evoloop reads version " + VERSION
                    + "; use the version of Evoloop that wrote it, or start with an empty directory");
        }
        if (content.length < BYTES) {
            throw tooShort(file, content);
        }
        return new Preamble(sure(bytes), place(file, bytes), endingOf(file, bytes), end(bytes));
    }

    private static JournalException tooShort(Path file, byte[] content) {
        return JournalException.ofDamage(
                file, ", byte " + content.length + ": it is cut, within its preamble of " + BYTES + " bytes");
    }

    /** Up to where the file is certainly on the disk; if the two copies disagree, one was being written. */
    private static int sure(ByteBuffer bytes) {
        long until = bytes.getLong(SURE_AT);
        return until == ~bytes.getLong(SURE_AT + 8) && until == (int) until ? (int) until : 0;
    }

    private static Place place(Path file, ByteBuffer bytes) {
        Place place = Place.read(bytes, PLACE_AT);
        if (place.crc() != bytes.getInt(PLACE_CRC_AT)) {
            throw JournalException.ofDamage(
                    file, ", byte " + PLACE_AT + ": its number and what came before do not match their checksum");
        }
        return place;
    }

    private static Ending endingOf(Path file, ByteBuffer bytes) {
        Ending ending = Ending.of(bytes.getInt(ENDING_AT));
        if (ending == null) {
            throw JournalException.ofDamage(file, ", byte " + ENDING_AT + ": the mark of its end is unknown");
        }
        return ending;
    }

    private static Link end(ByteBuffer bytes) {
        return bytes.getInt(ENDING_AT) == Ending.OPEN.code
                ? Link.NONE
                : new Link(bytes.getInt(ENDING_AT + 4), bytes.getLong(SUM_AT));
    }

    private static int crcOf(int version) {
        byte[] checked = ByteBuffer.allocate(VERSION_CRC_AT)
                .putLong(MAGIC)
                .putInt(version)
                .array();
        return Frame.crcOf(checked, 0, VERSION_CRC_AT);
    }
}
