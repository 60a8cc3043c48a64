package org.evoloop.roomba.camera;

/**
 * A camera that looks for the starting point's marker.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public interface MarkerCamera extends AutoCloseable {

    /** The newest look; never blocks. */
    Look newest();

    /**
     * Registers a listener that runs after every look, on the camera's thread; it must return at once.
     *
     * @return removes the listener; idempotent
     */
    Runnable onLook(Runnable listener);

    /** Ends the camera's thread and frees all native memory. Idempotent; waits at most 2 s. */
    @Override
    void close();
}
