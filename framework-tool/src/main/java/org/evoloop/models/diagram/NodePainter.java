package org.evoloop.models.diagram;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import org.evoloop.models.diagram.Diagram.Node;
import org.evoloop.models.diagram.Diagram.Shape;
import org.evoloop.models.diagram.Layout.Box;

/** Paints nodes in UML's notation. */
final class NodePainter {
    private final Svg svg;
    private final Map<String, Box> boxes;

    /** @param boxes of all nodes of the diagram, by key */
    NodePainter(Svg svg, Map<String, Box> boxes) {
        this.svg = svg;
        this.boxes = boxes;
    }

    void paint(Box box) {
        Node node = box.node();
        if (node.shape() == Shape.REGION) {
            return;
        }
        String kind = node.shape() == Shape.STATE ? "state" : "pseudostate";
        svg.open("g", "class", kind + " " + Palette.of(node.tone()).cssClass());
        if (node.shape() == Shape.STATE) {
            state(box);
        } else {
            pseudostate(box);
        }
        svg.close("g");
    }

    private void state(Box box) {
        Node node = box.node();
        double nameHeight =
                node.notes().isEmpty() && node.children().isEmpty() ? box.height() : NodeSize.nameHeight(node);
        svg.empty(
                "rect",
                "class",
                node.children().isEmpty() ? "box" : "box frame",
                "x",
                box.x(),
                "y",
                box.y(),
                "width",
                box.width(),
                "height",
                box.height(),
                "rx",
                12.0);
        List<String> name = NodeSize.name(node);
        double y = box.y() + (nameHeight - TextSize.height(name)) / 2;
        lines(name, "name", box.centreX(), y);
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
        svg.empty("path", "class", cssClass, "d", "M" + pair(x1, y1) + " L" + pair(x2, y2));
    }

    /** The dashed lines between the regions of an orthogonal state, which the layout puts in a row or in a column. */
    private void regions(Box frame) {
        List<Box> regions = frame.node().children().stream()
                .filter(child -> child.shape() == Shape.REGION)
                .map(child -> boxes.get(child.key()))
                .toList();
        List<Box> downwards =
                regions.stream().sorted(Comparator.comparingDouble(Box::y)).toList();
        List<Box> across =
                regions.stream().sorted(Comparator.comparingDouble(Box::x)).toList();
        double top = frame.y() + NodeSize.textHeight(frame.node());
        for (int i = 1; i < regions.size(); i++) {
            Box above = downwards.get(i - 1);
            Box left = across.get(i - 1);
            if (above.y() + above.height() <= downwards.get(i).y()) {
                double y = (above.y() + above.height() + downwards.get(i).y()) / 2;
                divider(frame, y, "line separator");
            } else if (left.x() + left.width() <= across.get(i).x()) {
                double x = (left.x() + left.width() + across.get(i).x()) / 2;
                line("line separator", x, top, x, frame.y() + frame.height());
            }
        }
    }

    private void lines(List<String> lines, String cssClass, double x, double top) {
        double baseline = top + TextSize.LINE_HEIGHT * 0.75;
        for (String line : lines) {
            svg.text("text", line, "class", cssClass, "x", x, "y", baseline);
            baseline += TextSize.LINE_HEIGHT;
        }
    }

    private void pseudostate(Box box) {
        double x = box.centreX();
        double y = box.centreY();
        double radius = box.width() / 2;
        switch (box.node().shape()) {
            case INITIAL, JUNCTION -> circle("solid", x, y, radius);
            case FINAL -> {
                circle("box hollow", x, y, radius);
                circle("solid", x, y, radius - 5);
            }
            case CHOICE ->
                svg.empty(
                        "path",
                        "class",
                        "box",
                        "d",
                        "M" + pair(x, y - radius) + " L" + pair(x + radius, y) + " L" + pair(x, y + radius) + " L"
                                + pair(x - radius, y) + " Z");
            case SHALLOW_HISTORY, DEEP_HISTORY -> {
                circle("box", x, y, radius);
                svg.text(
                        "text",
                        box.node().shape() == Shape.DEEP_HISTORY ? "H*" : "H",
                        "class",
                        "name",
                        "x",
                        x,
                        "y",
                        y + 4.5);
            }
            case ENTRY_POINT -> circle("box", x, y, radius);
            case EXIT_POINT -> {
                circle("box", x, y, radius);
                cross(x, y, radius * 0.7);
            }
            case TERMINATE -> cross(x, y, radius);
            case BAR ->
                svg.empty(
                        "rect",
                        "class",
                        "solid",
                        "x",
                        box.x(),
                        "y",
                        box.y(),
                        "width",
                        box.width(),
                        "height",
                        box.height());
            case STATE, REGION -> throw new IllegalArgumentException(box.node().key() + " is no pseudostate");
        }
        if (ElkLayout.isPoint(box.node())) {
            lines(NodeSize.name(box.node()), "middle", x, box.y() + box.height() + 4);
        }
    }

    private void circle(String cssClass, double x, double y, double radius) {
        svg.empty("circle", "class", cssClass, "cx", x, "cy", y, "r", radius);
    }

    private void cross(double x, double y, double arm) {
        svg.empty(
                "path",
                "class",
                "line",
                "d",
                "M" + pair(x - arm, y - arm) + " L" + pair(x + arm, y + arm) + " M" + pair(x - arm, y + arm) + " L"
                        + pair(x + arm, y - arm));
    }

    /** Coordinates as in a path. */
    static String pair(double x, double y) {
        return Svg.number(x) + " " + Svg.number(y);
    }
}
