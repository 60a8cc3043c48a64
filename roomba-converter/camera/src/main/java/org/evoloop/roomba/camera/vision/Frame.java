package org.evoloop.roomba.camera.vision;

/**
 * Room for a picture in native memory; made by {@link Vision#newFrame}, filled by a {@link FrameReader}, again and
 * again.
 *
 * <p>Threading: for one thread at a time.
 *
 * @since 0.1
 */
public interface Frame extends AutoCloseable {

    /** The size of what it holds; 0x0 while it is empty. */
    FrameSize size();

    /** Gives its memory back. Idempotent. */
    @Override
    void close();
}
