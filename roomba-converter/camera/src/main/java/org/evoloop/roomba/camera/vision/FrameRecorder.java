package org.evoloop.roomba.camera.vision;

import java.util.List;
import java.util.Optional;

/**
 * Records a camera's frames, with detections drawn in.
 *
 * <p>Threading: for one thread at a time.
 *
 * @since 0.1
 */
public interface FrameRecorder extends AutoCloseable {

    /**
     * Appends a frame, repeated or skipped so that the recording plays in real time; does nothing once the file has
     * reached its size limit.
     *
     * @param takenNanos when it arrived; must not decrease
     * @param captions lines of text to draw on it, in ASCII
     */
    void write(Frame frame, long takenNanos, Optional<Detection> detection, List<String> captions);

    /** Completes the file. Idempotent. */
    @Override
    void close();
}
