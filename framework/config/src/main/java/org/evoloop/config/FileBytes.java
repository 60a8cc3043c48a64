package org.evoloop.config;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.ReadableByteChannel;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Reads a file that may be a pipe, such as a shell's {@code <(...)}. The JDK's stream of a file may ask for a place in it,
 * depending on the JDK's version, which a pipe lacks; a channel only reads.
 */
final class FileBytes {
    private FileBytes() {}

    /** Its bytes, but {@code most} at most. */
    static byte[] first(int most, Path file) throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate(most);
        try (ReadableByteChannel in = Files.newByteChannel(file)) {
            while (bytes.hasRemaining() && in.read(bytes) >= 0) {}
        }
        byte[] read = new byte[bytes.flip().remaining()];
        bytes.get(read);
        return read;
    }
}
