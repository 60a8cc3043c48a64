package org.evoloop.roomba.simulator.room;

/** A straight part of something that a robot can bump into. */
record Segment(Point from, Point to) {

    /** The segment's point nearest to another point. */
    Point nearest(Point point) {
        Point along = to.minus(from);
        double lengthSquared = along.dot(along);
        double share = lengthSquared == 0 ? 0 : point.minus(from).dot(along) / lengthSquared;
        return from.plus(along, Math.max(0, Math.min(1, share)));
    }

    /** Whether the two segments have a point in common. */
    boolean crosses(Segment other) {
        double distance = other.hitBy(from, to.minus(from));
        return distance <= 1;
    }

    /** The distance along a ray to the segment, in lengths of {@code direction}; infinite if the ray misses it. */
    double hitBy(Point origin, Point direction) {
        Point along = to.minus(from);
        double parallel = direction.cross(along);
        if (parallel == 0) {
            return Double.POSITIVE_INFINITY;
        }
        Point apart = from.minus(origin);
        double distance = apart.cross(along) / parallel;
        double share = apart.cross(direction) / parallel;
        return distance >= 0 && share >= 0 && share <= 1 ? distance : Double.POSITIVE_INFINITY;
    }
}
