package org.evoloop.page.drawing;

import static org.evoloop.page.drawing.MachineDrawing.format;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.page.drawing.Graph.Arrow;
import org.evoloop.page.drawing.Graph.Box;

/**
 * The course of an arrow: smooth, through its boxes, from the edge of one state to the edge of the other. Its
 * head is a marker of the style sheet.
 */
final class Course {
    private record Point(double x, double y) {}

    private Course() {}

    static String of(Arrow arrow) {
        List<Point> points = points(arrow);
        StringBuilder path = new StringBuilder();
        Point at = points.get(0);
        path.append(format("M%.1f %.1f", at.x, at.y));
        for (int index = 1; index < points.size(); index++) {
            Point next = points.get(index);
            double middle = (at.y + next.y) / 2;
            path.append(format(" C%.1f %.1f %.1f %.1f %.1f %.1f", at.x, middle, next.x, middle, next.x, next.y));
            at = next;
        }
        return path.toString();
    }

    /** The points where it leaves its source, passes its boxes, and meets its target. */
    private static List<Point> points(Arrow arrow) {
        List<Box> way = arrow.way();
        List<Point> points = new ArrayList<>();
        Box second = way.get(1);
        points.add(edge(way.get(0), second, -1));
        boolean down = way.get(way.size() - 1).row > way.get(0).row;
        boolean up = way.get(way.size() - 1).row < way.get(0).row;
        for (Box box : way.subList(1, way.size() - 1)) {
            if (box == arrow.label() && (down || up)) {
                double half = box.height / 2;
                points.add(new Point(box.x, down ? box.y - half : box.y + half));
                points.add(new Point(box.x, down ? box.y + half : box.y - half));
            } else if (box == arrow.label()) {
                points.add(new Point(box.x, box.y - box.height / 2 + 2));
            } else {
                points.add(new Point(box.x, box.y));
            }
        }
        points.add(edge(way.get(way.size() - 1), way.get(way.size() - 2), 1));
        return points;
    }

    /** On the side that faces {@code other}, towards it; a loop begins and ends at two places. */
    private static Point edge(Box state, Box other, int side) {
        double reach = state.width / 2 - 12;
        double dx = Math.max(-reach, Math.min(reach, (other.x - state.x) * 0.5 + side * 5));
        return new Point(state.x + dx, other.y > state.y ? state.y + state.height / 2 : state.y - state.height / 2);
    }
}
