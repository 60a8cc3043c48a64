package org.evoloop.models.diagram;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.models.diagram.Diagram.Tone;
import org.evoloop.svg.Svg;

/** Draws a table; long text in a cell is wrapped. */
final class TablePainter {
    static final String STYLE = ".column { font-weight: bold }\n";

    private static final double LONGEST = 380;
    private static final double PADDING = 8;

    private static final double CAPTION = 28;

    private final String caption;
    private final List<List<List<String>>> cells = new ArrayList<>();
    private final List<Tone> tones = new ArrayList<>();
    private final double[] widths;

    TablePainter(Table table) {
        caption = table.caption();
        widths = new double[table.heading().size()];
        add(Tone.PLAIN, table.rows().isEmpty() ? List.of() : table.heading());
        table.rows().forEach(row -> add(row.tone(), row.cells()));
    }

    private void add(Tone tone, List<String> texts) {
        List<List<String>> row = new ArrayList<>();
        for (int column = 0; column < texts.size(); column++) {
            List<String> lines = TextSize.wrap(texts.get(column), LONGEST, cells.isEmpty());
            row.add(lines);
            widths[column] = Math.max(widths[column], TextSize.width(lines, cells.isEmpty()) + 2 * PADDING);
        }
        cells.add(row);
        tones.add(tone);
    }

    double width() {
        double width = 0;
        for (double column : widths) {
            width += column;
        }
        return Math.max(width, TextSize.width(caption, true));
    }

    double height() {
        return CAPTION + cells.stream().mapToDouble(TablePainter::height).sum();
    }

    private static double height(List<List<String>> row) {
        return row.stream().mapToDouble(TextSize::height).max().orElse(0) + PADDING;
    }

    /** Draws the table at the origin of the group opened last. */
    void paint(Svg svg) {
        svg.text("column", 0, TextSize.ASCENT, caption);
        double top = CAPTION;
        for (int row = 0; row < cells.size(); row++) {
            double height = height(cells.get(row));
            svg.group("row " + Palette.of(tones.get(row)).cssClass());
            if (row > 0) {
                svg.rectangle("box", 0, top, width(), height, 0);
            }
            double left = PADDING;
            for (int column = 0; column < cells.get(row).size(); column++) {
                double baseline = top + PADDING / 2 + TextSize.ASCENT;
                for (String line : cells.get(row).get(column)) {
                    svg.text(row == 0 ? "column" : "cell", left, baseline, line);
                    baseline += TextSize.LINE_HEIGHT;
                }
                left += widths[column];
            }
            svg.endGroup();
            top += height;
        }
    }
}
