package org.evoloop.roomba.camera;

/**
 * A camera that looks for the starting point's marker.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public interface MarkerCamera extends AutoCloseable {

    /** The newest look; never waits. */
    Look newest();

    /**
     * Has {@code listener} run after every look, on the camera's thread; it must return at once.
     *
     * @return ends it; idempotent
     */
    Runnable onLook(Runnable listener);

    /** Ends the camera's thread and gives all native memory back. Idempotent; waits for 2 s at most. */
    @Override
    void close();
}
