package org.evoloop.models.diagram;

import java.util.List;
import org.evoloop.models.diagram.Diagram.Node;

/** The sizes of nodes, in pixels, and the line breaks of their text. */
final class NodeSize {
    static final double MARGIN = 12;
    static final double NAME_MARGIN = 6;

    private static final double NAME_WIDTH = 210;
    private static final double NOTE_WIDTH = 260;
    private static final double LABEL_WIDTH = 190;

    private NodeSize() {}

    static List<String> name(Node node) {
        return TextSize.wrap(node.name(), NAME_WIDTH, true);
    }

    static List<String> notes(Node node) {
        return node.notes().stream()
                .flatMap(note -> TextSize.wrap(note, NOTE_WIDTH, false).stream())
                .toList();
    }

    static List<String> label(String text) {
        return TextSize.wrap(text, LABEL_WIDTH, false);
    }

    /** The width that the name and the notes of a state need. */
    static double textWidth(Node node) {
        double widest = Math.max(TextSize.width(name(node), true), TextSize.width(notes(node), false));
        return Math.max(widest + 2 * MARGIN, 70);
    }

    /** The height of a state's upper compartment. */
    static double nameHeight(Node node) {
        return TextSize.height(name(node)) + 2 * NAME_MARGIN;
    }

    /** The height of the compartments of a state, without its children. */
    static double textHeight(Node node) {
        double notes = node.notes().isEmpty() ? 0 : TextSize.height(notes(node)) + 2 * NAME_MARGIN;
        double least = node.notes().isEmpty() && node.children().isEmpty() ? 40 : 0;
        return Math.max(nameHeight(node) + notes, least);
    }

    /** The diameter of a shape drawn around a point; 0 for states and regions. */
    static double diameter(Diagram.Shape shape) {
        return switch (shape) {
            case INITIAL, ENTRY_POINT, EXIT_POINT, TERMINATE -> 16;
            case JUNCTION -> 12;
            case FINAL -> 20;
            case SHALLOW_HISTORY, DEEP_HISTORY, CHOICE -> 26;
            case BAR -> 6;
            case STATE, REGION -> 0;
        };
    }
}
