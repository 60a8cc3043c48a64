package org.evoloop.roomba.simulator.room;

/**
 * A point on the floor.
 *
 * @since 0.1
 */
public record Point(double xMm, double yMm) {
    Point plus(Point other, double factor) {
        return new Point(xMm + factor * other.xMm, yMm + factor * other.yMm);
    }

    Point minus(Point other) {
        return plus(other, -1);
    }

    double dot(Point other) {
        return xMm * other.xMm + yMm * other.yMm;
    }

    double cross(Point other) {
        return xMm * other.yMm - yMm * other.xMm;
    }
}
