package org.evoloop.models.diagram;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.evoloop.models.diagram.Diagram.Node;
import org.evoloop.models.diagram.Diagram.Shape;
import org.evoloop.models.diagram.Layout.Box;
import org.evoloop.svg.Svg;

/** Paints nodes in UML's notation. */
final class NodePainter {
    private static final double ROUNDNESS = 12;

    private final Svg svg;
    private final Map<String, Box> boxes;
    private final boolean plain;

    /**
     * @param boxes of all nodes of the diagram, by key
     * @param plain whether each has its data
     */
    NodePainter(Svg svg, Map<String, Box> boxes, boolean plain) {
        this.svg = svg;
        this.boxes = boxes;
        this.plain = plain;
    }

    void paint(Box box) {
        Node node = box.node();
        if (node.shape() == Shape.REGION) {
            return;
        }
        String kind = node.shape() == Shape.STATE ? "state" : "pseudostate";
        svg.group(kind + " " + Palette.of(node.tone()).cssClass(), plain ? node.data() : Map.of());
        if (node.shape() == Shape.STATE) {
            state(box);
        } else {
            pseudostate(box);
        }
        svg.endGroup();
    }

    private void state(Box box) {
        Node node = box.node();
        boolean nameOnly = node.notes().isEmpty() && node.children().isEmpty();
        double nameHeight = nameOnly ? box.height() : NodeSize.nameHeight(node);
        String cssClass = node.children().isEmpty() ? "box" : "box frame";
        svg.rectangle(cssClass, box.x(), box.y(), box.width(), box.height(), ROUNDNESS);
        List<String> name = NodeSize.name(node);
        lines(name, "name", box.centreX(), box.y() + (nameHeight - TextSize.height(name)) / 2);
        if (!node.notes().isEmpty()) {
            divider(box, box.y() + nameHeight, "line");
            lines(NodeSize.notes(node), "note", box.x() + NodeSize.MARGIN, box.y() + nameHeight + NodeSize.NAME_MARGIN);
        }
        if (!node.children().isEmpty()) {
            divider(box, box.y() + NodeSize.textHeight(node), "line");
            regions(box);
        }
    }

    private void divider(Box box, double y, String cssClass) {
        line(cssClass, box.x(), y, box.x() + box.width(), y);
    }

    private void line(String cssClass, double x1, double y1, double x2, double y2) {
        svg.line(cssClass, x1, y1, x2, y2);
    }

    /**
     * Draws the dashed lines between the regions of an orthogonal state, which the layout puts in a row or in a column.
     */
    private void regions(Box frame) {
        List<Box> regions = frame.node().children().stream()
                .filter(child -> child.shape() == Shape.REGION)
                .map(child -> Objects.requireNonNull(boxes.get(child.key())))
                .toList();
        List<Box> downwards =
                regions.stream().sorted(Comparator.comparingDouble(Box::y)).toList();
        List<Box> across =
                regions.stream().sorted(Comparator.comparingDouble(Box::x)).toList();
        double top = frame.y() + NodeSize.textHeight(frame.node());
        for (int i = 1; i < regions.size(); i++) {
            double above = downwards.get(i - 1).y() + downwards.get(i - 1).height();
            double left = across.get(i - 1).x() + across.get(i - 1).width();
            if (above <= downwards.get(i).y()) {
                divider(frame, (above + downwards.get(i).y()) / 2, "line separator");
            } else if (left <= across.get(i).x()) {
                double x = (left + across.get(i).x()) / 2;
                line("line separator", x, top, x, frame.y() + frame.height());
            }
        }
    }

    private void lines(List<String> lines, String cssClass, double x, double top) {
        double baseline = top + TextSize.ASCENT;
        for (String line : lines) {
            svg.text(cssClass, x, baseline, line);
            baseline += TextSize.LINE_HEIGHT;
        }
    }

    private void pseudostate(Box box) {
        double x = box.centreX();
        double y = box.centreY();
        double radius = box.width() / 2;
        switch (box.node().shape()) {
            case INITIAL, JUNCTION -> svg.circle("solid", x, y, radius);
            case FINAL -> svg.circle("box hollow", x, y, radius).circle("solid", x, y, radius - 5);
            case CHOICE -> diamond(x, y, radius);
            case SHALLOW_HISTORY -> svg.circle("box", x, y, radius).text("name", x, y + 4.5, "H");
            case DEEP_HISTORY -> svg.circle("box", x, y, radius).text("name", x, y + 4.5, "H*");
            case ENTRY_POINT -> svg.circle("box", x, y, radius);
            case EXIT_POINT -> {
                svg.circle("box", x, y, radius);
                cross(x, y, radius * 0.7);
            }
            case TERMINATE -> cross(x, y, radius);
            case BAR -> svg.rectangle("solid", box.x(), box.y(), box.width(), box.height(), 0);
            case STATE, REGION -> throw new IllegalArgumentException(box.node().key() + " is no pseudostate");
        }
        if (ElkLayout.hasNameBelow(box.node())) {
            lines(NodeSize.name(box.node()), "middle", x, box.y() + box.height() + 4);
        }
    }

    private void diamond(double x, double y, double radius) {
        svg.path(
                "box",
                "M" + Svg.pair(x, y - radius) + " L" + Svg.pair(x + radius, y) + " L" + Svg.pair(x, y + radius) + " L"
                        + Svg.pair(x - radius, y) + " Z");
    }

    private void cross(double x, double y, double arm) {
        line("line", x - arm, y - arm, x + arm, y + arm);
        line("line", x - arm, y + arm, x + arm, y - arm);
    }
}
