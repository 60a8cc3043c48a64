package org.evoloop.roomba.simulator.webcam;

import org.evoloop.roomba.simulator.eye.EyeOptions;

/**
 * The options of a served camera.
 *
 * @since 0.1
 */
public final class WebcamOptions {
    private static final int HIGHEST_PORT = 65_535;

    private final int port;
    private final double framesPerSecond;
    private final EyeOptions eye;

    private WebcamOptions(int port, double framesPerSecond, EyeOptions eye) {
        if (port < 0 || port > HIGHEST_PORT) {
            throw new IllegalArgumentException("camera port is " + port + "; allowed is 0 to " + HIGHEST_PORT);
        }
        if (!(framesPerSecond >= 0.1 && framesPerSecond <= 60)) {
            throw new IllegalArgumentException(
                    "camera frames per second are " + framesPerSecond + "; allowed is 0.1 to 60");
        }
        this.port = port;
        this.framesPerSecond = framesPerSecond;
        this.eye = eye;
    }

    /** A typical camera on any free port, 30 frames per second. */
    public static WebcamOptions defaults() {
        return new WebcamOptions(0, 30, EyeOptions.defaults());
    }

    /** A copy with another port. */
    public WebcamOptions withPort(int other) {
        return new WebcamOptions(other, framesPerSecond, eye);
    }

    /** A copy with another frame rate. */
    public WebcamOptions withFramesPerSecond(double frames) {
        return new WebcamOptions(port, frames, eye);
    }

    /** A copy with other camera options. */
    public WebcamOptions withEye(EyeOptions other) {
        return new WebcamOptions(port, framesPerSecond, other);
    }

    /** The port on this machine, 0 to 65535; 0 is any free port. */
    public int port() {
        return port;
    }

    /** Frames per second of the robot's time, 0.1 to 60; fewer when the simulation runs too fast to render them all. */
    public double framesPerSecond() {
        return framesPerSecond;
    }

    /** The camera's options. */
    public EyeOptions eye() {
        return eye;
    }
}
