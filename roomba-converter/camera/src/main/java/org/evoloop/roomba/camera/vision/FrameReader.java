package org.evoloop.roomba.camera.vision;

/**
 * An open source of frames.
 *
 * <p>Threading: for the thread that opened it, also for {@link #close}: a driver that is closed by another thread while
 * it waits for a frame may block forever.
 *
 * @since 0.1
 */
public interface FrameReader extends AutoCloseable {

    /** The result of waiting for a frame. */
    enum Received {
        /** The frame is filled. */
        FRAME,
        /** A frame arrived but cannot be used. */
        DAMAGED,
        /** The data could not be decoded, nothing arrived in time, or the source has ended. */
        NOTHING
    }

    /** Waits for the next frame, at most some seconds. */
    Received read(Frame into);

    @Override
    void close();
}
