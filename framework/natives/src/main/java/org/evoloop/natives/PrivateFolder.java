package org.evoloop.natives;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * A folder of a name that nobody can guess, which none but its owner may enter (mode 0700), for files that are loaded
 * as programs. It goes with {@link #close()}; a loaded file goes on without its name.
 *
 * <p>Most is done with {@link File}: it needs fewer classes, and a program starts only when its libraries are loaded.
 */
final class PrivateFolder implements AutoCloseable {
    private final File folder;

    private PrivateFolder(File folder) {
        this.folder = folder;
    }

    /**
     * A new folder in that for temporary files; in the home folder if files there must not be run (mounted noexec).
     *
     * @throws IOException if it can be made in neither
     */
    static PrivateFolder make() throws IOException {
        List<String> refusals = new ArrayList<>();
        for (String parent : List.of(System.getProperty("java.io.tmpdir"), System.getProperty("user.home"))) {
            try {
                // Its mode is 0700 from the start.
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

    /** The system denies the right to run any file on a file system that is mounted so. */
    private boolean mayRunFiles() throws IOException {
        File probe = file("probe");
        return probe.createNewFile() && probe.setExecutable(true) && probe.canExecute() && probe.delete();
    }

    /** One of its files, which need not exist. */
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
