package org.evoloop.service;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Reserves an instance's name with a lock on a file. The system releases the lock when its holder ends in any way. The
 * file stays, since another process may be about to lock it.
 */
final class InstanceLock implements AutoCloseable {
    private final FileChannel file;

    private InstanceLock(FileChannel file) {
        this.file = file;
    }

    /**
     * @param directory a private one
     * @throws IllegalArgumentException if a running instance has the name
     */
    static InstanceLock acquire(Path directory, String name) throws IOException {
        Path path = directory.resolve(name + ".lock");
        FileChannel file = FileChannel.open(
                path,
                Set.of(StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE),
                PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rw-------")));
        boolean ours = false;
        try {
            if (tryLock(file) == null) {
                throw new IllegalArgumentException("an instance named " + name + " is running already (process "
                        + Files.readString(path).strip() + "); give this one another --name, or end that one: ctl "
                        + name
                        + " exit");
            }
            note(file, path);
            ours = true;
            return new InstanceLock(file);
        } finally {
            if (!ours) {
                file.close();
            }
        }
    }

    /** Writes the number of this process into the locked file. */
    private static void note(FileChannel file, Path path) throws IOException {
        try {
            file.truncate(0);
            file.write(ByteBuffer.wrap((ProcessHandle.current().pid() + "\n").getBytes(StandardCharsets.US_ASCII)));
        } catch (IOException failure) {
            throw new IOException(path + " cannot be written: " + failure.getMessage(), failure);
        }
    }

    private static @Nullable FileLock tryLock(FileChannel file) throws IOException {
        try {
            return file.tryLock();
        } catch (OverlappingFileLockException thisProcess) {
            return null;
        }
    }

    @Override
    public void close() throws IOException {
        file.close();
    }
}
