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
     * Appends a frame, so often that the recording keeps time; nothing once the file is as large as it may be.
     *
     * @param takenNanos when it came; must not go back
     * @param captions lines of text to write into it, in ASCII
     */
    void write(Frame frame, long takenNanos, Optional<Detection> detection, List<String> captions);

    /** Completes the file. Idempotent. */
    @Override
    void close();
}
