package org.evoloop.page.server;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Optional;
import java.util.Set;

/**
 * The file in which a page's token outlives the program. Only its owner may read it.
 *
 * <p>Threading: immutable.
 *
 * @param option the option that names it, for messages
 * @param path its path
 * @since 0.1
 */
public record TokenFile(String option, Path path) {
    private static final String SECRET = "[A-Za-z0-9_-]{16,128}";
    private static final Set<PosixFilePermission> OWNERS = PosixFilePermissions.fromString("rw-------");

    /**
     * The token in the file; empty if there is none yet.
     *
     * @throws IllegalArgumentException if it cannot be used; the message says what to do
     */
    public Optional<String> read() {
        try {
            if (!Files.exists(path, LinkOption.NOFOLLOW_LINKS)) {
                return Optional.empty();
            }
            if (!Files.isRegularFile(path)) {
                throw refused("is not a regular file; name one, or one that does not exist yet");
            }
            if (!OWNERS.containsAll(Files.getPosixFilePermissions(path))) {
                throw refused("may be read or written by others; allow only its owner to (chmod 600)");
            }
            String token = Files.readString(path, StandardCharsets.UTF_8).strip();
            if (!token.matches(SECRET)) {
                throw refused(
                        "holds no token of 16 to 128 letters, digits, _ and -; delete it, and the program writes a"
                                + " new one");
            }
            return Optional.of(token);
        } catch (IOException unreadable) {
            throw refused("cannot be read (" + reason(unreadable) + "); let this program's user read it");
        }
    }

    /**
     * Writes the file, entirely or not at all.
     *
     * @throws IOException if that is impossible; the message says what to do
     */
    public void write(String token) throws IOException {
        try {
            Path folder = path.toAbsolutePath().getParent();
            // Created with mode 0600.
            Path fresh = Files.createTempFile(folder, "." + path.getFileName(), "");
            try {
                Files.writeString(fresh, token + "\n");
                Files.move(fresh, path, StandardCopyOption.ATOMIC_MOVE);
            } finally {
                Files.deleteIfExists(fresh);
            }
        } catch (IOException unwritten) {
            throw new IOException(
                    option + " is " + path + ", which cannot be written (" + reason(unwritten)
                            + "); name a file in a folder that this program's user may write to",
                    unwritten);
        }
    }

    private static String reason(IOException failure) {
        String reason = failure instanceof FileSystemException file ? file.getReason() : failure.getMessage();
        return reason == null ? failure.getClass().getSimpleName() : reason;
    }

    private IllegalArgumentException refused(String why) {
        return new IllegalArgumentException(option + " is " + path + ", which " + why);
    }
}
