package org.evoloop.roomba.camera.vision;

import java.util.Optional;
import org.evoloop.roomba.camera.CameraException;
import org.evoloop.roomba.camera.Sighting;

/**
 * Looks for one marker.
 *
 * <p>Threading: for one thread at a time.
 *
 * @since 0.1
 */
public interface MarkerFinder extends AutoCloseable {

    /**
     * The marker in this frame; the nearest one if there are several.
     *
     * @throws CameraException if the camera's model does not fit the frame's size
     */
    Optional<Detection> detect(Frame frame);

    /**
     * The marker in this picture.
     *
     * @param pixels row by row from the top, one byte each (gray) or three (blue, green, red)
     * @throws IllegalArgumentException if their number does not fit the size
     * @throws CameraException if the camera's model does not fit the size
     */
    Optional<Sighting> find(byte[] pixels, int width, int height);

    /** Frees its memory. Idempotent. */
    @Override
    void close();
}
