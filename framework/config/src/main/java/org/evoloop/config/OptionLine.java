package org.evoloop.config;

import java.nio.file.Path;
import java.util.List;

/**
 * An option in a file of another kind than that of {@code --config}, whose reader has found it there.
 *
 * @param name without dashes
 * @param values as they are written
 * @param isList whether they are written as a list
 * @param file the values' relative paths are relative to its directory
 * @param line in the file, from 1
 * @since 0.1
 */
public record OptionLine(String name, List<String> values, boolean isList, Path file, int line) {
    public OptionLine {
        values = List.copyOf(values);
    }

    Entry entry() {
        Origin origin = Origin.in(file, line);
        return new Entry(
                name,
                origin,
                isList,
                true,
                values.stream().map(text -> new Entry.Value(text, origin)).toList());
    }
}
