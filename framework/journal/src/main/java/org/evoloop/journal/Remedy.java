package org.evoloop.journal;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** What to do with a journal that is not as it was written. Nothing is deleted by any of it. */
final class Remedy {
    /**
     * The directory, inside that of the journal, for segments without which the converter is to go on. While it is
     * there, the oldest segments may be missing.
     */
    static final String ASIDE = "aside";

    private Remedy() {}

    static boolean isSetAside(Path directory) {
        return Files.isDirectory(directory.resolve(ASIDE));
    }

    /** For a segment that cannot be read. */
    static String ofDamage(Path file) {
        Path directory = file.toAbsolutePath().getParent();
        List<Path> segments =
                directory == null || !Files.isDirectory(directory) ? List.of() : Directory.segments(directory);
        for (Path later : segments) {
            if (later.getFileName().compareTo(file.getFileName()) > 0) {
                return ofMissing(later);
            }
        }
        return "restore " + file.getFileName() + " from a copy; if there is none, keep the directory under another name"
                + " and start with an empty one";
    }

    /** For a segment that is missing or wrong, when the next one is there. */
    static String ofMissing(Path next) {
        String name = next.getFileName().toString();
        return "restore the file from a copy; if there is none, move all segments before " + name
                + " into the directory " + next.resolveSibling(ASIDE) + " (create it): the converter goes on from "
                + name + ", which begins with its complete state";
    }
}
