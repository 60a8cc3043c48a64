package org.evoloop.roomba.camera;

/** A camera, OpenCV or a file for them cannot be used; the message says which, why, and the mend. */
public final class CameraException extends RuntimeException {
    private final String problem;

    public CameraException(String problem) {
        super(problem);
        this.problem = problem;
    }

    public CameraException(String problem, Throwable cause) {
        super(problem, cause);
        this.problem = problem;
    }

    @Override
    public String getMessage() {
        return problem;
    }
}
