package org.evoloop.journal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * A segment, read record by record. A record that was being written when the process or the computer ended is ignored;
 * a damaged record is refused.
 */
final class SegmentReader {
    private final Path file;
    private final byte[] bytes;
    private final ByteBuffer buffer;
    private final Cursor cursor;
    private final long sure;
    private final Head head;
    private final String snapshot;

    /** From the head, once it has been read. */
    private String boot = "";

    private int next = Preamble.BYTES;
    private int at;
    private int length;
    private long records;
    private boolean torn;

    /** @throws JournalException if it cannot be read, is damaged, or of another version */
    SegmentReader(Path file) {
        this(file, read(file));
    }

    private SegmentReader(Path file, byte[] bytes) {
        this.file = file;
        this.bytes = bytes;
        this.buffer = ByteBuffer.wrap(bytes);
        this.cursor = new Cursor(bytes);
        Preamble.require(file, bytes);
        this.sure = Preamble.sure(bytes);
        requireNext("its head");
        Head read;
        try {
            cursor.goTo(at, length);
            read = Head.read(cursor);
        } catch (RuntimeException e) {
            throw damaged("the head is inconsistent: " + e.getMessage());
        }
        this.head = read;
        this.boot = read.boot();
        requireNext("a snapshot");
        this.snapshot = new String(bytes, at, length, StandardCharsets.UTF_8);
        // The first record is the first input.
        records = 0;
    }

    /** The used size of {@code file}; 0 if it was being created when the process or the computer ended. */
    static long writtenBytes(Path file) {
        byte[] bytes = read(file);
        if (Preamble.isBlank(bytes)) {
            return 0;
        }
        int written = bytes.length;
        while (bytes[written - 1] == 0) {
            written--;
        }
        return written;
    }

    private static byte[] read(Path file) {
        if (!Files.isRegularFile(file)) {
            // Reading a pipe would never end.
            throw new JournalException(file + " cannot be read: it is "
                    + (Files.exists(file) ? "not a regular file" : "missing")
                    + "; restore a copy of the directory, or use another");
        }
        try {
            return Files.readAllBytes(file);
        } catch (AccessDeniedException e) {
            throw new JournalException(
                    file + " cannot be read: permission denied; grant this user read permission, or use another "
                            + "directory",
                    e);
        } catch (IOException e) {
            throw new JournalException(file + " cannot be read: " + e.getMessage(), e);
        } catch (OutOfMemoryError e) {
            throw new JournalException(
                    file + " cannot be read: its " + file.toFile().length() + " bytes do not fit into this program's"
                            + " memory; give it more (-Xmx), or use another directory",
                    e);
        }
    }

    private void requireNext(String what) {
        if (!next()) {
            throw damaged("it ends before " + what);
        }
    }

    Head head() {
        return head;
    }

    String snapshot() {
        return snapshot;
    }

    Cursor cursor() {
        return cursor;
    }

    /** Advances to the next record; false if there is none. */
    boolean next() {
        if (bytes.length - next < Frame.HEADER_BYTES) {
            return ends(!isZeroFrom(next));
        }
        long header = buffer.getLong(next);
        if (header == 0) {
            boolean begun = !isZeroFrom(next);
            if (begun && next < sure) {
                throw damaged("its header is blank, and something follows");
            }
            return ends(begun);
        }
        if (!Frame.isSound(header)) {
            return endsAtRagged("the check of its length is wrong");
        }
        int payload = next + Frame.HEADER_BYTES;
        int size = Frame.length(header);
        int after = payload + Frame.padded(size);
        if (after > bytes.length) {
            return ends(true);
        }
        if (Frame.crcOf(bytes, payload, size) != Frame.crc(header) || !isZero(payload + size, after)) {
            return endsAtRagged("its checksum is wrong");
        }
        at = payload;
        length = size;
        next = after;
        records++;
        return true;
    }

    private boolean isZeroFrom(int from) {
        return isZero(from, bytes.length);
    }

    private boolean isZero(int from, int until) {
        for (int index = from; index < until; index++) {
            if (bytes[index] != 0) {
                return false;
            }
        }
        return true;
    }

    private boolean ends(boolean isTorn) {
        torn = isTorn;
        return false;
    }

    /** Only a power cut leaves such a record, beyond the part certainly on the disk. */
    private boolean endsAtRagged(String what) {
        boolean powerCut = !boot.isEmpty() && !boot.equals(Boot.ID);
        if (next < sure || !powerCut) {
            throw damagedNext(what);
        }
        return ends(true);
    }

    /** The offset of the present record in the file, in bytes. */
    int at() {
        return at;
    }

    int length() {
        return length;
    }

    /** The kind of the present record, if it is an input. */
    Kind kind() {
        return Kind.of(bytes[at]);
    }

    /** The number of the present record in its segment, from 1. */
    long number() {
        return records;
    }

    /** Whether the last record was being written when the process ended. */
    boolean isTorn() {
        return torn;
    }

    /** The end of the last complete record. */
    int end() {
        return next;
    }

    long size() {
        return bytes.length;
    }

    /** An exception for the present record, which makes no sense. */
    JournalException damaged(String what) {
        return wrong(at - Frame.HEADER_BYTES, records, what);
    }

    private JournalException damagedNext(String what) {
        return wrong(next, records + 1, what);
    }

    private JournalException wrong(int place, long number, String what) {
        return JournalException.ofDamage(file + ", byte " + place + ", record " + number + ": " + what);
    }
}
