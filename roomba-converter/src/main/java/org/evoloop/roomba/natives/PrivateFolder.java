package org.evoloop.roomba.natives;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/**
 * A folder of a name that nobody can guess, which none but its owner may enter (mode 0700), for files that are loaded as
 * programs. It goes with {@link #close()}; a loaded file goes on without its name.
 */
final class PrivateFolder implements AutoCloseable {
    private static final String PREFIX = "evoloop-native-";
    private static final FileAttribute<Set<PosixFilePermission>> OWNER_ONLY =
            PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------"));

    private final Path path;

    private PrivateFolder(Path path) {
        this.path = path;
    }

    /**
     * A new folder in that for temporary files; in the home folder if files there must not be run (mounted noexec).
     *
     * @throws IOException if it can be made in neither
     */
    static PrivateFolder make() throws IOException {
        IOException refused = new IOException("files there must not be run (mounted noexec)");
        for (Path parent :
                List.of(Path.of(System.getProperty("java.io.tmpdir")), Path.of(System.getProperty("user.home")))) {
            try {
                PrivateFolder folder = new PrivateFolder(Files.createTempDirectory(parent, PREFIX, OWNER_ONLY));
                if (folder.mayRunFiles()) {
                    return folder;
                }
                folder.close();
            } catch (IOException failure) {
                refused.addSuppressed(failure);
            }
        }
        throw refused;
    }

    /** The system denies the right to run any file on a file system that is mounted so. */
    private boolean mayRunFiles() throws IOException {
        Path probe = Files.createFile(path.resolve("probe"), OWNER_ONLY);
        try {
            return Files.isExecutable(probe);
        } finally {
            Files.delete(probe);
        }
    }

    Path path() {
        return path;
    }

    @Override
    public void close() throws IOException {
        try (Stream<Path> files = Files.list(path)) {
            for (Path file : files.toList()) {
                Files.delete(file);
            }
        }
        Files.delete(path);
    }
}
