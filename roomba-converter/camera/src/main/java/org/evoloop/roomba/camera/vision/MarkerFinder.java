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
     * The marker in that frame; the nearest one, should it be there more than once.
     *
     * @throws CameraException if the camera's model does not fit the frame's size
     */
    Optional<Detection> detect(Frame frame);

    /**
     * The marker in that picture.
     *
     * @param pixels row by row from above, a byte each (gray) or three (blue, green, red)
     * @throws IllegalArgumentException if their number does not fit the size
     * @throws CameraException if the camera's model does not fit it
     */
    Optional<Sighting> find(byte[] pixels, int width, int height);

    /** Gives its memory back. Idempotent. */
    @Override
    void close();
}
