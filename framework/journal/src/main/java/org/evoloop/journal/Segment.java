package org.evoloop.journal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.MappedByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileChannel.MapMode;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * A file that is being written. All its bytes are allocated when it is created, so that a record needs no call of the
 * operating system and cannot find the disk full; what is in the mapped memory outlives the process.
 *
 * <p>Threading: one thread appends, another may force.
 */
final class Segment implements AutoCloseable {
    private static final int CHUNK_BYTES = 1 << 16;

    private Path file;
    private final FileChannel channel;
    private final MappedByteBuffer map;
    private volatile int end = Preamble.BYTES;
    private int sure = Preamble.BYTES;

    /** @throws IOException if it exists, or there is no room for it; then nothing is left of it */
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
        } catch (IOException e) {
            channel.close();
            file.toFile().delete();
            throw e;
        }
    }

    Path file() {
        return file;
    }

    /** How many bytes it takes on the disk while it is written. */
    int size() {
        return map.capacity();
    }

    /** Gives the file another name, before it {@linkplain #begin is one}. */
    void moveTo(Path name) throws IOException {
        Files.move(file, name);
        file = name;
    }

    /** It is not needed: nothing is left of it. */
    void discard() {
        try {
            channel.close();
            Files.deleteIfExists(file);
        } catch (IOException left) {
            // The next one that is prepared takes its place.
        }
    }

    /** Appends a record; false if there is no room for it. */
    boolean append(byte[] bytes, int length) {
        int at = end;
        int payload = at + Frame.HEADER_BYTES;
        if (length > Frame.MOST_BYTES || Frame.padded(length) > map.capacity() - payload) {
            return false;
        }
        map.put(payload, bytes, 0, length);
        Frame.finish(map, at, Frame.header(length, Frame.crcOf(bytes, 0, length)));
        end = payload + Frame.padded(length);
        return true;
    }

    /** From now on it is one: its first records are there. */
    void begin() {
        Preamble.write(map);
    }

    /** Whether something was written that is not on the disk for sure. */
    boolean isDirty() {
        return sure != end;
    }

    /** Puts all on the disk that has been appended. */
    synchronized void force() {
        int until = end;
        if (sure != until) {
            map.force(0, until);
            if (sure == Preamble.BYTES) {
                Directory.force(file.toAbsolutePath().resolveSibling(""));
            }
            sure = until;
            Preamble.sure(map, until);
        }
    }

    /** Gives back the room that was not needed; nothing may be appended any more. */
    @Override
    public void close() throws IOException {
        try {
            channel.truncate(end);
        } catch (IOException stillMapped) {
            // Windows does not let a mapped file be shortened; the zeros at its end mean nothing.
        } finally {
            channel.close();
        }
    }
}
