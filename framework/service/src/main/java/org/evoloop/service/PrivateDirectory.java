package org.evoloop.service;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Set;

/** A directory that only its owner may enter. */
final class PrivateDirectory {
    private static final Set<PosixFilePermission> OURS_ALONE = PosixFilePermissions.fromString("rwx------");

    private PrivateDirectory() {}

    /**
     * Creates {@code directory}, or makes an existing one private.
     *
     * @throws IOException if it cannot be created, or belongs to somebody else; the message says what to do
     */
    static void prepare(Path directory) throws IOException {
        try {
            // Created with its final mode, so that others can never enter it.
            Files.createDirectory(directory, PosixFilePermissions.asFileAttribute(OURS_ALONE));
        } catch (FileAlreadyExistsException there) {
            requireOwn(directory);
            if (!Files.getPosixFilePermissions(directory).equals(OURS_ALONE)) {
                Files.setPosixFilePermissions(directory, OURS_ALONE);
            }
        } catch (IOException failure) {
            throw new IOException(
                    "the directory " + directory + " for control sockets cannot be made (" + failure
                            + "); set XDG_RUNTIME_DIR to a directory of your own",
                    failure);
        }
    }

    /** Whether {@code directory} is a directory, not a link to one, and belongs to this user. */
    static boolean isOwn(Path directory) {
        try {
            return owns(directory);
        } catch (IOException unknown) {
            return false;
        }
    }

    private static boolean owns(Path directory) throws IOException {
        return Files.isDirectory(directory, LinkOption.NOFOLLOW_LINKS)
                && owner(directory).equals(user());
    }

    private static void requireOwn(Path directory) throws IOException {
        if (!owns(directory)) {
            throw new IOException(
                    directory + " is not a directory of this user; it is where control sockets are kept. Remove"
                            + " it, or set XDG_RUNTIME_DIR to a directory of your own");
        }
    }

    /** The user of this process, found as the owner of a new file. */
    private static Object user() throws IOException {
        Path made = Files.createTempFile("evoloop", "");
        try {
            return owner(made);
        } finally {
            Files.delete(made);
        }
    }

    private static Object owner(Path file) throws IOException {
        return Files.getAttribute(file, "unix:uid", LinkOption.NOFOLLOW_LINKS);
    }
}
