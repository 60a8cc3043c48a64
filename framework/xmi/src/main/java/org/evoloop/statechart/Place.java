package org.evoloop.statechart;

/**
 * Where something stands in a file, for messages.
 *
 * @param id of the element in the file; empty if it has none
 * @param line counted from 1; 0 if it stands in no file
 * @since 0.1
 */
public record Place(String id, int line) {
    /** Of what stands in no file. */
    public static final Place NONE = new Place("", 0);

    /** For messages: {@code line 12, id ek-39}; empty for {@link #NONE}. */
    @Override
    public String toString() {
        String where = line > 0 ? "line " + line : "";
        String which = id.isEmpty() ? "" : "id " + id;
        return where.isEmpty() || which.isEmpty() ? where + which : where + ", " + which;
    }
}
