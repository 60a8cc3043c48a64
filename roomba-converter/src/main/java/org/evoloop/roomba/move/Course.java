package org.evoloop.roomba.move;

/**
 * What the robot has to do to come to the starting point.
 *
 * <p>Threading: immutable.
 */
sealed interface Course {
    /** Nearer than this the robot has arrived. */
    double ARRIVED_MM = 20;

    /** Seen further to the side than this, the robot turns on the spot first: 20 degrees. */
    double TURN_RAD = Math.toRadians(20);

    /** It is there. */
    record Arrived() implements Course {}

    /** The point lies ahead, more or less. */
    record Approach(double distanceMm, double bearingRad) implements Course {}

    /** The point lies to the side or behind. */
    record Turn(double bearingRad) implements Course {}

    /** The point is not seen. */
    record Lost() implements Course {}

    /** The robot does not obey drive commands. */
    record OutOfControl() implements Course {}

    /** The course to a point that is seen. */
    static Course to(StartPointSensor.Sighting sighting) {
        if (sighting.distanceMm() < ARRIVED_MM) {
            return new Arrived();
        }
        return Math.abs(sighting.bearingRad()) > TURN_RAD
                ? new Turn(sighting.bearingRad())
                : new Approach(sighting.distanceMm(), sighting.bearingRad());
    }
}
