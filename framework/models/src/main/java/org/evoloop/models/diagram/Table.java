package org.evoloop.models.diagram;

import java.util.List;
import org.evoloop.models.diagram.Diagram.Tone;

/**
 * A table below the machines of a picture.
 *
 * <p>Threading: immutable.
 *
 * @param caption the text above it; empty if there is no table, which then has no rows
 * @param heading the names of the columns
 */
public record Table(String caption, List<String> heading, List<Row> rows) {
    /** No table. */
    static final Table NONE = new Table("", List.of(), List.of());

    public Table {
        heading = List.copyOf(heading);
        rows = List.copyOf(rows);
    }

    /** A row, with one cell per column. */
    public record Row(Tone tone, List<String> cells) {
        public Row {
            cells = List.copyOf(cells);
        }
    }
}
