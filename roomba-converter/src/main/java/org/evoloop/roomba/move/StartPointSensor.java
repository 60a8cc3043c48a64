package org.evoloop.roomba.move;

import java.util.Optional;
import org.evoloop.roomba.camera.CameraHealth;
import org.evoloop.roomba.camera.Look;
import org.evoloop.roomba.camera.MarkerCamera;
import org.evoloop.roomba.camera.Sighting;
import org.evoloop.roomba.move.phase.Target;
import org.evoloop.roomba.session.Telemetry;

/**
 * Senses where the starting point is.
 *
 * <p>Threading: called from one thread at a time, once a frame of the robot's stream; must not wait.
 */
public interface StartPointSensor extends AutoCloseable {

    /**
     * What was sensed last.
     *
     * @param nowNanos on the clock that also dates the look
     */
    Look look(Telemetry telemetry, long nowNanos);

    /** Ends what it was opened for. Idempotent; waits for 2 s at most. */
    @Override
    default void close() {}

    /** How near the robot has to come to what it senses. */
    Target target();

    /** Knows the point by dead reckoning: {@code xMm} ahead and {@code yMm} left of where the session began. */
    static StartPointSensor byWheels(double xMm, double yMm) {
        return new StartPointSensor() {
            @Override
            public Look look(Telemetry telemetry, long nowNanos) {
                Sighting sighting = new Sighting(
                        telemetry.pose().distanceTo(xMm, yMm), telemetry.pose().bearingTo(xMm, yMm));
                return new Look(telemetry.frame(), nowNanos, CameraHealth.SEEING, Optional.of(sighting));
            }

            @Override
            public Target target() {
                return new Target(0, 20, false);
            }
        };
    }

    /**
     * Sees the point's marker, with a camera that is closed along with this; the robot arrives 0.40 m before it,
     * looking at it.
     */
    static StartPointSensor byCamera(MarkerCamera camera) {
        return new StartPointSensor() {
            @Override
            public Look look(Telemetry telemetry, long nowNanos) {
                return camera.newest();
            }

            @Override
            public Target target() {
                return new Target(400, 20, true);
            }

            @Override
            public void close() {
                camera.close();
            }
        };
    }
}
