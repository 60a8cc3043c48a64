package org.evoloop.roomba.simulator.room;

import java.util.ArrayList;
import java.util.List;

/**
 * A polygon on the floor; its last corner is joined with its first.
 *
 * @param corners at least three
 * @param finish how its sides look
 * @since 0.1
 */
public record Shape(Kind kind, List<Point> corners, Finish finish) {

    /** What the polygon stands for. */
    public enum Kind {
        /** Its sides are walls without thickness, the floor goes on inside. */
        WALL,
        /** Something solid. */
        OBSTACLE,
        /** Within it there is no floor. */
        CLIFF
    }

    public Shape {
        corners = List.copyOf(corners);
        if (corners.size() < 3) {
            throw new IllegalArgumentException("a shape has " + corners.size() + " corners; it needs three or more");
        }
    }

    /** A shape of any look. */
    public Shape(Kind kind, List<Point> corners) {
        this(kind, corners, Finish.ANY);
    }

    /** The corners of a rectangle along the axes, by two of them that are opposite. */
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

    /** Whether a point is inside: a ray from there to the right then crosses an odd number of sides. */
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
