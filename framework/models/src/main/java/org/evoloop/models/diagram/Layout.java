package org.evoloop.models.diagram;

import java.util.List;

/**
 * A diagram with all coordinates, in pixels from the top left corner.
 *
 * <p>Threading: immutable.
 *
 * @param boxes outer ones before those inside
 */
record Layout(double width, double height, List<Box> boxes, List<Wire> wires) {
    Layout {
        boxes = List.copyOf(boxes);
        wires = List.copyOf(wires);
    }

    record Point(double x, double y) {}

    /** A node with its top left corner and its size. */
    record Box(Diagram.Node node, double x, double y, double width, double height) {
        double centreX() {
            return x + width / 2;
        }

        double centreY() {
            return y + height / 2;
        }
    }

    /**
     * An edge.
     *
     * @param points from source to target, with right angles between
     * @param label the lines of its label
     * @param at the top left corner of the label
     */
    record Wire(Diagram.Edge edge, List<Point> points, List<String> label, Point at) {
        Wire {
            points = List.copyOf(points);
            label = List.copyOf(label);
        }
    }
}
