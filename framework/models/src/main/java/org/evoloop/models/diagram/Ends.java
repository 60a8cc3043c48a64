package org.evoloop.models.diagram;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.models.diagram.Diagram.Shape;
import org.evoloop.models.diagram.Layout.Box;
import org.evoloop.models.diagram.Layout.Point;

/**
 * Moves the ends of edges from a node's bounding box, where the layout puts them, to the outline of round and slanted
 * shapes.
 */
final class Ends {
    private Ends() {}

    /** The same path, but from the outline of {@code source} to the outline of {@code target}. */
    static List<Point> onOutlines(List<Point> points, Box source, Box target) {
        List<Point> touching = new ArrayList<>(points);
        touching.set(0, outline(source, points.get(0), points.get(1)));
        int last = points.size() - 1;
        touching.set(last, outline(target, points.get(last), points.get(last - 1)));
        return touching;
    }

    /** Where the horizontal or vertical line from {@code outside} to {@code end} meets the shape. */
    private static Point outline(Box box, Point end, Point outside) {
        boolean level = end.y() == outside.y();
        double offset = level ? end.y() - box.centreY() : end.x() - box.centreX();
        double reach = reach(box.node().shape(), box.width() / 2, Math.abs(offset));
        if (reach < 0) {
            return end;
        }
        return level
                ? new Point(box.centreX() + Math.copySign(reach, outside.x() - box.centreX()), end.y())
                : new Point(end.x(), box.centreY() + Math.copySign(reach, outside.y() - box.centreY()));
    }

    /** The half-width of the shape at distance {@code offset} from its centre line; negative for rectangles. */
    private static double reach(Shape shape, double radius, double offset) {
        return switch (shape) {
            case STATE, REGION, BAR, TERMINATE -> -1;
            case CHOICE -> Math.max(radius - offset, 0);
            default -> Math.sqrt(Math.max(radius * radius - offset * offset, 0));
        };
    }
}
