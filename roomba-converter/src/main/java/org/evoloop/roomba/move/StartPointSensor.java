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
 * <p>Threading: called from one thread at a time, once per frame of the robot's stream; must not block.
 */
public interface StartPointSensor extends AutoCloseable {

    /**
     * The last look.
     *
     * @param nowNanos the time on the clock that also dates the look
     */
    Look look(Telemetry telemetry, long nowNanos);

    /** Releases what the sensor uses. Idempotent; waits at most 2 s. */
    @Override
    default void close() {}

    /** Which distance from the sensed place counts as arrived. */
    Target target();

    /** Locates the point by dead reckoning: {@code xMm} ahead and {@code yMm} left of where the session began. */
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
     * Finds the point's marker with a camera, which is closed with this sensor. The robot arrives 0.40 m in front of
     * the marker, facing it.
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
