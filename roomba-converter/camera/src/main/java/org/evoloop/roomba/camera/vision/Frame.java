package org.evoloop.roomba.camera.vision;

/**
 * A picture buffer in native memory; created by {@link Vision#newFrame}, filled by a {@link FrameReader}, and reused.
 *
 * <p>Threading: for one thread at a time.
 *
 * @since 0.1
 */
public interface Frame extends AutoCloseable {

    /** The size of its picture; 0x0 while it is empty. */
    FrameSize size();

    /** Frees its memory. Idempotent. */
    @Override
    void close();
}
