package org.evoloop.statechart;

import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A place in a file, for messages.
 *
 * @param file if it is another one than that of the machine, from which the element is imported; else empty
 * @param id of the element in the file; empty if it has none
 * @param line counted from 1; 0 if it is not in a file
 * @since 0.1
 */
public record Place(String file, String id, int line) {
    /** The place of something that is not in a file. */
    public static final Place NONE = new Place("", 0);

    /** A place in the machine's own file. */
    public Place(String id, int line) {
        this("", id, line);
    }

    /** For messages: {@code line 12, id ek-39}, after the file if that is another one; empty for {@link #NONE}. */
    @Override
    public String toString() {
        return Stream.of(file, line > 0 ? "line " + line : "", id.isEmpty() ? "" : "id " + id)
                .filter(part -> !part.isEmpty())
                .collect(Collectors.joining(", "));
    }
}
