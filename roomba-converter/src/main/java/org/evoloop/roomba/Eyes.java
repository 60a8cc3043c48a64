package org.evoloop.roomba;

import java.time.Duration;
import java.util.function.Function;
import org.evoloop.roomba.camera.live.CameraSettings;
import org.evoloop.roomba.camera.live.VideoCamera;
import org.evoloop.roomba.camera.vision.OpenCv;
import org.evoloop.roomba.camera.vision.Vision;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.time.Clock;

/** The camera as Move's sensor. */
final class Eyes {
    private Eyes() {}

    /**
     * Opens the camera when Move begins, and closes it when Move ends.
     *
     * @param pace how many times faster than real time the robot runs; the camera's computer does not run faster
     * @throws org.evoloop.roomba.camera.CameraException if OpenCV is missing; the message says what to install
     */
    static Function<Clock, StartPointSensor> through(CameraSettings settings, double pace) {
        Vision vision = OpenCv.vision();
        Duration stale = Duration.ofNanos(Math.round(settings.staleAfter().toNanos() * Math.max(1, pace)));
        // Move itself accepts the marker only when several frames in a row agree.
        CameraSettings each = settings.withFramesInARow(1).withStaleAfter(stale);
        return clock -> StartPointSensor.byCamera(VideoCamera.open(vision, each, clock));
    }
}
