package org.evoloop.console;

import java.util.List;
import org.jline.terminal.Size;
import org.jline.terminal.Terminal;

/**
 * Lines at the bottom of a terminal's output that are redrawn in place.
 *
 * <p>Threading: used under its user's lock.
 */
final class LiveText {
    private static final String ERASE_ALL = "\u001b[H\u001b[2J";

    private static final int USUAL_HEIGHT = 24;

    private final Terminal terminal;
    private String text = "";
    private int rows;
    private int columns;

    LiveText(Terminal terminal) {
        this.terminal = terminal;
        columns = terminal.getSize().getColumns();
    }

    /** Replaces the shown text by {@code newText}. */
    void draw(String newText) {
        text = newText;
        show("");
    }

    /** Prints {@code lines} above, permanently. */
    void above(String lines) {
        show(lines + "\n");
    }

    /** In one write, so that the terminal never shows half of it. */
    private void show(String before) {
        StringBuilder drawn = new StringBuilder();
        Size size = terminal.getSize();
        if (columns != size.getColumns()) {
            // The terminal has rewrapped the lines: their number is unknown.
            columns = size.getColumns();
            drawn.append(ERASE_ALL);
        } else if (rows > 0) {
            drawn.append("\r\u001b[" + rows + "A\u001b[J");
        }
        List<String> lines = Wrapping.wrap(text, TerminalIo.fit(columns, Wrapping.USUAL_WIDTH))
                .lines()
                .limit(size.getRows() > 1 ? size.getRows() - 1 : USUAL_HEIGHT)
                .toList();
        rows = lines.size();
        drawn.append(before);
        lines.forEach(line -> drawn.append(line).append('\n'));
        terminal.writer().print(drawn);
        terminal.flush();
    }
}
