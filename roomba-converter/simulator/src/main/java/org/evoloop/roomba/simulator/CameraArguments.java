package org.evoloop.roomba.simulator;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.roomba.simulator.eye.Effects;
import org.evoloop.roomba.simulator.eye.EyeOptions;
import org.evoloop.roomba.simulator.webcam.WebcamOptions;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** The command line options for {@link WebcamOptions}, which checks the values. */
final class CameraArguments {
    private static final Pattern SIZE = Pattern.compile("(\\d{1,5})x(\\d{1,5})");

    @Option(
            names = "--camera",
            paramLabel = "PORT",
            description = "Serves what a camera on the robot sees at http://127.0.0.1:PORT, for browsers and as "
                    + "motion JPEG; 0 is any free port.")
    private @Nullable Integer port;

    @Option(
            names = "--camera-quality",
            paramLabel = "clean|typical|hard",
            description = "What lens, sensor and light do to the pictures (default: typical).")
    private @Nullable String quality;

    @Option(names = "--camera-size", paramLabel = "WxH", description = "In pixels (default: 640x480).")
    private @Nullable String size;

    @Option(
            names = "--camera-fov",
            paramLabel = "DEGREES",
            description = "The field of view from left to right, 20 to 120 (default: 60).")
    private @Nullable Double fieldOfViewDeg;

    @Option(
            names = "--camera-fps",
            paramLabel = "N",
            description = "Frames in a second of the robot's time, 0.1 to 60 (default: 30).")
    private @Nullable Double framesPerSecond;

    /**
     * The options; empty if there is no camera.
     *
     * @throws IllegalArgumentException naming the invalid option
     */
    Optional<WebcamOptions> toOptions() {
        Integer wantedPort = port;
        if (wantedPort == null) {
            if (quality != null || size != null || fieldOfViewDeg != null || framesPerSecond != null) {
                throw new IllegalArgumentException(
                        "--camera-quality, --camera-size, --camera-fov and --camera-fps go" + " with --camera PORT");
            }
            return Optional.empty();
        }
        WebcamOptions usual = WebcamOptions.defaults();
        EyeOptions eye = sized(usual.eye());
        if (quality != null) {
            eye = eye.withEffects(Effects.named(quality));
        }
        if (fieldOfViewDeg != null) {
            eye = eye.withFieldOfViewDeg(fieldOfViewDeg);
        }
        double rate = framesPerSecond == null ? usual.framesPerSecond() : framesPerSecond;
        return Optional.of(usual.withPort(wantedPort).withFramesPerSecond(rate).withEye(eye));
    }

    private EyeOptions sized(EyeOptions usual) {
        String wanted = size;
        if (wanted == null) {
            return usual;
        }
        Matcher matcher = SIZE.matcher(wanted);
        if (!matcher.matches()) {
            throw new IllegalArgumentException(
                    "--camera-size is '" + wanted + "'; it takes WxH in pixels, for example 640x480");
        }
        return usual.withSize(Integer.parseInt(matcher.group(1)), Integer.parseInt(matcher.group(2)));
    }
}
