package org.evoloop.roomba.simulator.room;

import java.util.ArrayList;
import java.util.List;

/**
 * A polygon on the floor; its last corner is connected to its first.
 *
 * @param corners at least three
 * @param finish how its sides look
 * @since 0.1
 */
public record Shape(Kind kind, List<Point> corners, Finish finish) {

    /** What the polygon represents. */
    public enum Kind {
        /** Its sides are walls without thickness; there is floor inside. */
        WALL,
        /** Something solid. */
        OBSTACLE,
        /** There is no floor inside. */
        CLIFF
    }

    public Shape {
        corners = List.copyOf(corners);
        if (corners.size() < 3) {
            throw new IllegalArgumentException("a shape has " + corners.size() + " corners; it needs three or more");
        }
    }

    /** A shape with the default finish. */
    public Shape(Kind kind, List<Point> corners) {
        this(kind, corners, Finish.ANY);
    }

    /** The corners of an axis-parallel rectangle, from two opposite corners. */
    static List<Point> rectangle(Point one, Point other) {
        return List.of(one, new Point(other.xMm(), one.yMm()), other, new Point(one.xMm(), other.yMm()));
    }

    List<Segment> sides() {
        List<Segment> sides = new ArrayList<>();
        for (int i = 0; i < corners.size(); i++) {
            sides.add(new Segment(corners.get(i), corners.get((i + 1) % corners.size())));
        }
        return sides;
    }

    /** Whether a point is inside: then a ray from it to the right crosses an odd number of sides. */
    boolean contains(Point point) {
        boolean inside = false;
        for (Segment side : sides()) {
            boolean spans = side.from().yMm() > point.yMm() != side.to().yMm() > point.yMm();
            if (spans && point.xMm() < crossingXMm(side, point.yMm())) {
                inside = !inside;
            }
        }
        return inside;
    }

    private static double crossingXMm(Segment side, double yMm) {
        Point along = side.to().minus(side.from());
        return side.from().xMm() + (yMm - side.from().yMm()) / along.yMm() * along.xMm();
    }
}
