package org.evoloop.config;

import java.nio.file.Path;
import org.jspecify.annotations.Nullable;

/**
 * Where a value came from.
 *
 * @param file null for the command line
 * @param line in the file, from 1
 */
record Origin(@Nullable Path file, int line) {
    static final Origin COMMAND_LINE = new Origin(null, 0);

    static Origin in(Path file, int line) {
        return new Origin(file, line);
    }

    boolean isFile() {
        return file != null;
    }

    /** The mistake with options named as in this place: {@code --port} is {@code port} in a file. */
    String named(String mistake) {
        return isFile() ? mistake.replaceAll("(?<![\\w-])--(?=[a-z])(?!help\\b)", "") : mistake;
    }

    /** The mistake with this place, if it is one in a file. */
    String describe(String mistake) {
        return isFile() ? this + ": " + mistake : mistake;
    }

    /** {@code roomba.yaml:3}, or {@code command line}. */
    @Override
    public String toString() {
        return file == null ? "command line" : file + ":" + line;
    }
}
