package org.evoloop.journal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.evoloop.engine.codec.ByteItems;
import org.evoloop.journal.Place.Link;

/**
 * A segment, read record by record. A record that was being written when the process or the computer ended is ignored;
 * a damaged record is refused.
 */
final class SegmentReader {
    private final Path file;
    private final byte[] bytes;
    private final ByteBuffer buffer;
    private final ByteItems cursor;
    private final Preamble preamble;
    private final Head head;
    private final String snapshot;

    /** From the head, once it has been read. */
    private String boot = "";

    private int next = Preamble.BYTES;
    private int at;
    private int length;
    private long headers;
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
        this.cursor = ByteItems.withTable(bytes);
        this.preamble = Preamble.of(file, bytes);
        requireSize();
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
        requireUncut();
        requireNext("a snapshot");
        this.snapshot = new String(bytes, at, length, StandardCharsets.UTF_8);
        // The first record is the first input.
        records = 0;
    }

    /**
     * The beginning of {@code file}.
     *
     * @throws JournalException as the constructor
     */
    static Preamble preamble(Path file) {
        return Preamble.of(file, read(file));
    }

    /** A closed segment ends where it says, unless the unused room could not be released. */
    private void requireSize() {
        int most = preamble.place().bytes();
        int end = isOpen() ? preamble.sure() : preamble.end().end();
        if (bytes.length < end) {
            throw cut("it was written up to byte " + end);
        }
        if (bytes.length > most || (!isOpen() && bytes.length != end && bytes.length != most)) {
            throw JournalException.ofDamage(file, ", byte " + (isOpen() ? most : end) + ": something follows its end");
        }
    }

    /** A killed process leaves all the room that it had reserved. */
    private void requireUncut() {
        if (isOpen() && bytes.length < preamble.place().bytes() && !isBeforePowerCut()) {
            throw cut("its process reserved " + preamble.place().bytes() + " bytes");
        }
    }

    private JournalException cut(String why) {
        return JournalException.ofDamage(file, ", byte " + bytes.length + ": it is cut there; " + why);
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

    Path file() {
        return file;
    }

    Head head() {
        return head;
    }

    String snapshot() {
        return snapshot;
    }

    ByteItems cursor() {
        return cursor;
    }

    /** Advances to the next record; false if there is none. */
    boolean next() {
        if (!isOpen() && next >= preamble.end().end()) {
            requireEnd();
            return ends(false);
        }
        if (bytes.length - next < Frame.HEADER_BYTES) {
            return endsUnwritten("it is cut");
        }
        long header = buffer.getLong(next);
        if (header == 0) {
            return endsUnwritten("its header is blank");
        }
        if (!Frame.isSound(header)) {
            return endsAtRagged("the check of its length is wrong");
        }
        int payload = next + Frame.HEADER_BYTES;
        int size = Frame.length(header);
        int after = payload + Frame.padded(size);
        if (after > bytes.length) {
            return endsAtRagged("its length of " + size + " bytes goes beyond the end of the file");
        }
        if (Frame.crcOf(bytes, payload, size) != Frame.crc(header) || !isZero(payload + size, after)) {
            return endsAtRagged("its checksum is wrong");
        }
        at = payload;
        length = size;
        next = after;
        headers = Frame.sum(headers, header);
        records++;
        return true;
    }

    /** Whether it has no end yet, as while it is written, or after a kill. */
    private boolean isOpen() {
        return preamble.ending() == Preamble.Ending.OPEN;
    }

    private void requireEnd() {
        if (!link().equals(preamble.end())) {
            throw JournalException.ofDamage(
                    file, ", byte 88: its records end at " + link() + ", but it was closed at " + preamble.end());
        }
    }

    /** No record was completed there. */
    private boolean endsUnwritten(String what) {
        if (!isOpen() || next < preamble.sure()) {
            throw damagedNext(what + ", though more was written");
        }
        return ends(!isZeroFrom(next));
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
        if (!isOpen() || next < preamble.sure() || !isBeforePowerCut()) {
            throw damagedNext(what);
        }
        return ends(true);
    }

    /** Whether the computer has been restarted since it began, so that what was not forced may be missing. */
    boolean isBeforePowerCut() {
        return Boot.hasEnded(boot);
    }

    Preamble preamble() {
        return preamble;
    }

    /** The end of the last complete record, with the sum of all. */
    Link link() {
        return new Link(next, Frame.sum(headers, preamble.place().crc()));
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
        return JournalException.ofDamage(file, ", byte " + place + ", record " + number + ": " + what);
    }
}
