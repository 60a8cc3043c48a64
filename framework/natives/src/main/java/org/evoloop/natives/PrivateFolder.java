package org.evoloop.natives;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * A folder with an unguessable name that only its owner may enter (mode 0700), for native libraries. {@link #close()}
 * deletes it; libraries that are loaded continue to work.
 *
 * <p>Mostly uses {@link File}, which needs fewer classes: a program starts only after its libraries are loaded.
 */
final class PrivateFolder implements AutoCloseable {
    private final File folder;

    private PrivateFolder(File folder) {
        this.folder = folder;
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
                Path made = Files.createTempDirectory(Path.of(parent), "evoloop-native-");
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

    /** On a file system mounted noexec, no file is executable. */
    private boolean mayRunFiles() throws IOException {
        File probe = file("probe");
        return probe.createNewFile() && probe.setExecutable(true) && probe.canExecute() && probe.delete();
    }

    /** A file in this folder, which may not exist. */
    File file(String name) {
        return new File(folder, name);
    }

    @Override
    public void close() throws IOException {
        File[] files = folder.listFiles();
        for (File file : files == null ? new File[0] : files) {
            Files.delete(file.toPath());
        }
        Files.delete(folder.toPath());
    }
}
