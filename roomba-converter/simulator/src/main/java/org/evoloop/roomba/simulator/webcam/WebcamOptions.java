package org.evoloop.roomba.simulator.webcam;

import org.evoloop.roomba.simulator.eye.EyeOptions;

/**
 * What can be chosen about a served camera.
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

    /** A typical camera at any free port, 30 frames a second. */
    public static WebcamOptions defaults() {
        return new WebcamOptions(0, 30, EyeOptions.defaults());
    }

    /** The same at another port. */
    public WebcamOptions withPort(int other) {
        return new WebcamOptions(other, framesPerSecond, eye);
    }

    /** The same with so many frames a second. */
    public WebcamOptions withFramesPerSecond(double frames) {
        return new WebcamOptions(port, frames, eye);
    }

    /** The same that sees otherwise. */
    public WebcamOptions withEye(EyeOptions other) {
        return new WebcamOptions(port, framesPerSecond, other);
    }

    /** The port of this machine, 0 to 65535; 0 is any that is free. */
    public int port() {
        return port;
    }

    /**
     * Frames in a second of the robot's time, 0.1 to 60; fewer come when the robot lives so fast that they cannot be
     * made.
     */
    public double framesPerSecond() {
        return framesPerSecond;
    }

    /** What it sees. */
    public EyeOptions eye() {
        return eye;
    }
}
