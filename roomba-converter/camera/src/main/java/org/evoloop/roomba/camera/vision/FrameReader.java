package org.evoloop.roomba.camera.vision;

/**
 * A source that is open.
 *
 * <p>Threading: for the thread that opened it, {@link #close} included: a driver that is closed while it waits for a
 * frame may wait for ever.
 *
 * @since 0.1
 */
public interface FrameReader extends AutoCloseable {

    /** What came of waiting for a frame. */
    enum Outcome {
        /** The frame is filled. */
        FRAME,
        /** A frame came and cannot be used. */
        DAMAGED,
        /** What came could not be read, nothing came in time, or nothing will come any more. */
        NOTHING
    }

    /** Waits for the next frame, some seconds at most. */
    Outcome read(Frame into);

    @Override
    void close();
}
