package org.evoloop.roomba.camera;

/**
 * A camera, OpenCV or a file for them cannot be used; the message says which, why, and how to fix it.
 *
 * @since 0.1
 */
public final class CameraException extends RuntimeException {
    private final String problem;

    /** @param problem for the user, see above */
    public CameraException(String problem) {
        super(problem);
        this.problem = problem;
    }

    /** @param problem for the user; includes what the user needs to know of {@code cause}, thrown by a library */
    public CameraException(String problem, Throwable cause) {
        super(problem, cause);
        this.problem = problem;
    }

    @Override
    public String getMessage() {
        return problem;
    }
}
