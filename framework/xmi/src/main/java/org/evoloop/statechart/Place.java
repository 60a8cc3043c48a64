package org.evoloop.statechart;

/**
 * A place in a file, for messages.
 *
 * @param id of the element in the file; empty if it has none
 * @param line counted from 1; 0 if it is not in a file
 * @since 0.1
 */
public record Place(String id, int line) {
    /** The place of something that is not in a file. */
    public static final Place NONE = new Place("", 0);

    /** For messages: {@code line 12, id ek-39}; empty for {@link #NONE}. */
    @Override
    public String toString() {
        String where = line > 0 ? "line " + line : "";
        String which = id.isEmpty() ? "" : "id " + id;
        return where.isEmpty() || which.isEmpty() ? where + which : where + ", " + which;
    }
}
