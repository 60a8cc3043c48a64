package org.evoloop.journal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.MappedByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileChannel.MapMode;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Objects;
import org.evoloop.journal.Place.Link;
import org.jspecify.annotations.Nullable;

/**
 * A file that is being written. All its bytes are allocated when it is created, so that a record needs no system call
 * and cannot find the disk full; the contents of the mapped memory outlive the process.
 *
 * <p>Threading: one thread appends, another may force.
 */
final class Segment implements AutoCloseable {
    private static final int CHUNK_BYTES = 1 << 16;

    /** Pages may be larger; then the next one is touched too often, which is harmless. */
    private static final int PAGE_BYTES = 1 << 12;

    private Path file;
    private final FileChannel channel;
    private final MappedByteBuffer map;
    private volatile int end = Preamble.BYTES;
    private int sure = Preamble.BYTES;
    private long headers;
    private int place;
    private boolean closed;
    private final @Nullable Object key;
    private volatile boolean lost;

    /** @throws IOException if it exists, or there is no room for it; then no file is left */
    Segment(Path file, int bytes) throws IOException {
        this.file = file;
        this.channel = FileChannel.open(
                file, StandardOpenOption.CREATE_NEW, StandardOpenOption.READ, StandardOpenOption.WRITE);
        try {
            ByteBuffer zeros = ByteBuffer.allocate(CHUNK_BYTES);
            for (int left = bytes; left > 0; ) {
                zeros.position(0).limit(Math.min(left, CHUNK_BYTES));
                left -= channel.write(zeros);
            }
            map = channel.map(MapMode.READ_WRITE, 0, bytes);
            key = attributes().fileKey();
        } catch (IOException e) {
            channel.close();
            file.toFile().delete();
            throw e;
        }
    }

    Path file() {
        return file;
    }

    /** Its size on the disk, in bytes, while it is written. */
    int size() {
        return map.capacity();
    }

    private BasicFileAttributes attributes() throws IOException {
        return Files.readAttributes(file, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
    }

    /** Deletes the segment, which is not needed. */
    void discard() {
        try {
            channel.close();
            Files.deleteIfExists(file);
        } catch (IOException left) {
            // The next prepared segment overwrites it.
        }
    }

    /** Appends a record; false if there is no room for it. */
    boolean append(byte[] bytes, int length) {
        int at = end;
        int payload = at + Frame.HEADER_BYTES;
        if (length > Frame.MOST_BYTES || Frame.padded(length) > map.capacity() - payload) {
            return false;
        }
        int crc;
        if (length <= Frame.SHORT_BYTES) {
            // One byte at a time: the code of a bulk put has left the processor's caches when a rare event needs it.
            for (int index = 0; index < length; index++) {
                map.put(payload + index, bytes[index]);
            }
            crc = Frame.crcOfShort(bytes, length);
        } else {
            map.put(payload, bytes, 0, length);
            crc = Frame.crcOf(bytes, 0, length);
        }
        long header = Frame.header(length, crc);
        Frame.finish(map, at, header);
        headers = Frame.sum(headers, header);
        end = payload + Frame.padded(length);
        return true;
    }

    /**
     * Makes it a valid segment, after its first records, and gives it its name.
     *
     * @throws IOException if that is impossible; it is deleted then
     */
    void begin(Path name, Place begun) throws IOException {
        Preamble.write(map, begun);
        place = begun.crc();
        try {
            Files.move(file, name);
            file = name;
        } catch (FileAlreadyExistsException other) {
            discard();
            throw new IOException(name + " is there already, and is none of its segments; move it away", other);
        } catch (IOException e) {
            discard();
            throw e;
        }
    }

    /** Where it ends now. */
    Link link() {
        return new Link(end, Frame.sum(headers, place));
    }

    /** Looks whether the file is still what it was, so that what is appended can be read again. */
    void look() {
        try {
            BasicFileAttributes present = attributes();
            lost = !Objects.equals(present.fileKey(), key) || present.size() < map.capacity();
        } catch (IOException gone) {
            lost = true;
        }
    }

    /** Whether the file had been removed, replaced or cut at the last {@linkplain #look}. */
    boolean isLost() {
        return lost;
    }

    /** Whether something was written that may not be on the disk yet. */
    boolean isDirty() {
        return sure != end;
    }

    /** Forces everything appended to the disk. */
    synchronized void force() {
        int until = end;
        if (sure != until) {
            map.force(0, until);
            if (sure == Preamble.BYTES) {
                Directory.force(file.toAbsolutePath().resolveSibling(""));
            }
            sure = until;
            Preamble.sure(map, until);
            if (!closed) {
                makeWritable(until);
            }
        }
    }

    /**
     * Touches the next records' place: the system has write-protected the pages that it put on the disk, and the first
     * write to each would hold up an event. A record that is being written there stays as it is.
     */
    private void makeWritable(int from) {
        for (int at = from; at < map.capacity() && at <= nextPage(from); at = nextPage(at)) {
            Frame.touch(map, at);
        }
    }

    private static int nextPage(int at) {
        return (at | (PAGE_BYTES - 1)) + 1;
    }

    /** Notes where it ends, and releases the unused room; nothing may be appended any more. */
    @Override
    public synchronized void close() throws IOException {
        if (closed) {
            return;
        }
        closed = true;
        try {
            Preamble.close(map, link());
            channel.truncate(end);
        } catch (IOException stillMapped) {
            // Windows cannot truncate a mapped file; the zeros at its end are harmless.
        } finally {
            channel.close();
        }
    }
}
