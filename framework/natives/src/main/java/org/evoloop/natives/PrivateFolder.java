package org.evoloop.natives;

import java.io.File;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.UserPrincipal;
import java.util.ArrayList;
import java.util.List;

/**
 * A folder with an unguessable name that only its owner may enter (mode 0700), for native libraries. {@link #close()}
 * deletes it; libraries that are loaded continue to work. One that a killed process has left is deleted when the next
 * one is made: a process holds a lock in its folder, which the system releases however the process ends.
 *
 * <p>Mostly uses {@link File}, which needs fewer classes: a program starts only after its libraries are loaded.
 */
final class PrivateFolder implements AutoCloseable {
    private static final String NAME = "evoloop-native-";
    private static final String LOCK = "lock";

    /** A process that has made its folder holds the lock by then. */
    private static final long LOCKED_MILLIS = 60_000;

    private final File folder;
    private final FileChannel lock;

    private PrivateFolder(File folder) throws IOException {
        this.folder = folder;
        File unlocked = file("unlocked");
        lock = FileChannel.open(unlocked.toPath(), StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
        lock.lock();
        // Under this name, nobody ever sees it unlocked while its process lives.
        Files.move(unlocked.toPath(), file(LOCK).toPath());
    }

    /**
     * Creates a folder in the one for temporary files, or in the home folder if files there must not be executed
     * (mounted noexec).
     *
     * @throws IOException if neither is possible
     */
    static PrivateFolder make() throws IOException {
        List<String> refusals = new ArrayList<>();
        for (String parent : List.of(System.getProperty("java.io.tmpdir"), System.getProperty("user.home"))) {
            try {
                // Created with mode 0700.
                Path made = Files.createTempDirectory(Path.of(parent), NAME);
                deleteAbandoned(made);
                PrivateFolder folder = new PrivateFolder(made.toFile());
                if (folder.mayRunFiles()) {
                    return folder;
                }
                folder.close();
                refusals.add("no file in " + parent + " may be run, it is mounted noexec");
            } catch (IOException failure) {
                refusals.add("no folder can be made in " + parent);
            }
        }
        throw new IOException(String.join("; ", refusals));
    }

    /** Deletes the folders beside this one that belong to the same user, and to no process any more. */
    private static void deleteAbandoned(Path made) throws IOException {
        UserPrincipal owner = Files.getOwner(made);
        File[] others = made.toFile().getParentFile().listFiles((parent, name) -> name.startsWith(NAME));
        for (File other : others == null ? new File[0] : others) {
            Path path = other.toPath();
            try {
                if (!path.equals(made)
                        && Files.isDirectory(path, LinkOption.NOFOLLOW_LINKS)
                        && Files.getOwner(path, LinkOption.NOFOLLOW_LINKS).equals(owner)
                        && isAbandoned(other)) {
                    delete(other);
                }
            } catch (IOException goneOrAnothers) {
                // Its process, or another one, is about to delete it.
            }
        }
    }

    private static boolean isAbandoned(File folder) throws IOException {
        File lock = new File(folder, LOCK);
        if (!lock.exists()) {
            return System.currentTimeMillis() - folder.lastModified() > LOCKED_MILLIS;
        }
        try (FileChannel channel = FileChannel.open(lock.toPath(), StandardOpenOption.WRITE)) {
            return channel.tryLock() != null;
        } catch (OverlappingFileLockException ownProcess) {
            return false;
        }
    }

    /** On a file system mounted noexec, no file is executable. */
    private boolean mayRunFiles() throws IOException {
        File probe = file("probe");
        return probe.createNewFile() && probe.setExecutable(true) && probe.canExecute() && probe.delete();
    }

    /** A file in this folder, which may not exist. */
    File file(String name) {
        return new File(folder, name);
    }

    private static void delete(File folder) throws IOException {
        File[] files = folder.listFiles();
        for (File file : files == null ? new File[0] : files) {
            Files.delete(file.toPath());
        }
        Files.delete(folder.toPath());
    }

    @Override
    public void close() throws IOException {
        try (lock) {
            delete(folder);
        }
    }
}
