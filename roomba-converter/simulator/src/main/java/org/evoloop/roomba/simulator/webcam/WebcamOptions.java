package org.evoloop.roomba.simulator.webcam;

import org.evoloop.roomba.simulator.eye.EyeOptions;

/**
 * What can be chosen about a served camera.
 *
 * @param port of this machine, 0 to 65535; 0 is any that is free
 * @param framesPerSecond of the robot's time, 0.1 to 60; fewer come when the robot lives so fast that they cannot be made
 * @since 0.1
 */
public record WebcamOptions(int port, double framesPerSecond, EyeOptions eye) {
    private static final int HIGHEST_PORT = 65_535;

    public WebcamOptions {
        if (port < 0 || port > HIGHEST_PORT) {
            throw new IllegalArgumentException("camera port is " + port + "; allowed is 0 to " + HIGHEST_PORT);
        }
        if (!(framesPerSecond >= 0.1 && framesPerSecond <= 60)) {
            throw new IllegalArgumentException(
                    "camera frames per second are " + framesPerSecond + "; allowed is 0.1 to 60");
        }
    }

    /** A typical camera at any free port, 30 frames a second. */
    public static WebcamOptions defaults() {
        return new WebcamOptions(0, 30, EyeOptions.defaults());
    }
}
