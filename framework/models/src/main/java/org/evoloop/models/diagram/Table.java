package org.evoloop.models.diagram;

import java.util.List;
import org.evoloop.models.diagram.Diagram.Tone;

/**
 * What stands under the machines of a picture, row by row.
 *
 * <p>Threading: immutable.
 *
 * @param caption stands above it; empty if there is none, and then there must be no rows
 * @param heading what each column is
 */
public record Table(String caption, List<String> heading, List<Row> rows) {
    /** Nothing. */
    static final Table NONE = new Table("", List.of(), List.of());

    public Table {
        heading = List.copyOf(heading);
        rows = List.copyOf(rows);
    }

    /** A row, with a cell for each column. */
    public record Row(Tone tone, List<String> cells) {
        public Row {
            cells = List.copyOf(cells);
        }
    }
}
