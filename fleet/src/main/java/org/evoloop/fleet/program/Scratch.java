package org.evoloop.fleet.program;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/**
 * A temporary directory, deleted when the program ends.
 *
 * @since 0.1
 */
public final class Scratch implements AutoCloseable {
    private final Path directory;

    /** A new directory, on a disk rather than in memory. */
    public Scratch() throws IOException {
        directory = Files.createTempDirectory(Path.of("/var/tmp"), "evoloop-fleet-");
    }

    /** Its path. */
    public Path directory() {
        return directory;
    }

    @Override
    public void close() throws IOException {
        List<Path> all;
        try (Stream<Path> walk = Files.walk(directory)) {
            all = walk.sorted(Comparator.reverseOrder()).toList();
        }
        for (Path each : all) {
            Files.deleteIfExists(each);
        }
    }
}
