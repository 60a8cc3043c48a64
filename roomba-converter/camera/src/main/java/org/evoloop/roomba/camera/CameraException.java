package org.evoloop.roomba.camera;

/**
 * A camera, OpenCV or a file for them cannot be used; the message says which, why, and how to fix it.
 *
 * @since 0.1
 */
public final class CameraException extends RuntimeException {
    private final String problem;

    /** The problem is told to the user as it is, see above. */
    public CameraException(String problem) {
        super(problem);
        this.problem = problem;
    }

    /** With what was thrown by a library, whose message the problem repeats as far as a user needs it. */
    public CameraException(String problem, Throwable cause) {
        super(problem, cause);
        this.problem = problem;
    }

    @Override
    public String getMessage() {
        return problem;
    }
}
