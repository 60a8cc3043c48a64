package org.evoloop.roomba.move;

import java.util.Optional;
import org.evoloop.roomba.session.Telemetry;

/**
 * Senses where the starting point is.
 *
 * <p>Threading: called from one thread at a time, once a frame of the robot's stream; must not wait.
 */
@FunctionalInterface
public interface StartPointSensor {

    /** Where the starting point is seen from the robot; empty if it is not seen. */
    Optional<Sighting> look(Telemetry telemetry);

    /**
     * Where something is seen.
     *
     * @param distanceMm how far away, in mm, not negative
     * @param bearingRad counterclockwise from straight ahead, -pi to pi
     */
    record Sighting(double distanceMm, double bearingRad) {}

    /** Knows the point by dead reckoning: {@code xMm} ahead and {@code yMm} left of where the session began. */
    static StartPointSensor byWheels(double xMm, double yMm) {
        return telemetry -> Optional.of(new Sighting(
                telemetry.pose().distanceTo(xMm, yMm), telemetry.pose().bearingTo(xMm, yMm)));
    }
}
