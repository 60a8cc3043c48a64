package org.evoloop.roomba;

import java.time.Duration;
import java.util.Locale;
import java.util.function.Function;
import org.evoloop.page.Picture;
import org.evoloop.roomba.camera.CameraHealth;
import org.evoloop.roomba.camera.MarkerCamera;
import org.evoloop.roomba.camera.live.CameraPreview;
import org.evoloop.roomba.camera.live.CameraSettings;
import org.evoloop.roomba.camera.live.VideoCamera;
import org.evoloop.roomba.camera.vision.OpenCv;
import org.evoloop.roomba.camera.vision.Vision;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.jspecify.annotations.Nullable;

/**
 * The camera as Move's sensor: opened when Move begins, and closed when Move ends. People may see what it sees.
 *
 * <p>Threading: thread-safe.
 */
final class Eyes implements Function<Clock, StartPointSensor> {
    private static final String NO_PICTURE =
            "No picture yet. The camera is used only while Move drives the robot to its starting point; open this page then.";
    private static final CameraHealth UNUSED = new CameraHealth(CameraHealth.Condition.CLOSED, "");
    private static final Duration LIVE = Duration.ofSeconds(3);

    private final Vision vision;
    private final CameraSettings settings;
    private final CameraPreview preview;
    private volatile @Nullable MarkerCamera camera;

    /**
     * @param pace how many times faster than real time the robot runs; the camera's computer does not run faster
     * @throws org.evoloop.roomba.camera.CameraException if OpenCV is missing; the message says what to install
     */
    Eyes(CameraSettings settings, double pace) {
        this(OpenCv.vision(), settings, pace, new SystemClock());
    }

    /** @param viewers the clock of those who look at the picture */
    Eyes(Vision vision, CameraSettings settings, double pace, Clock viewers) {
        this.vision = vision;
        Duration stale = Duration.ofNanos(Math.round(settings.staleAfter().toNanos() * Math.max(1, pace)));
        // Move itself accepts the marker only when several frames in a row agree.
        this.settings = settings.withFramesInARow(1).withStaleAfter(stale);
        preview = new CameraPreview(vision, viewers);
    }

    @Override
    public StartPointSensor apply(Clock clock) {
        MarkerCamera opened = VideoCamera.open(vision, settings, clock, preview::offer);
        camera = opened;
        return StartPointSensor.byCamera(opened);
    }

    /** What the camera sees, for the page. */
    Picture picture() {
        return new Picture("Camera", "What the robot's camera sees, or saw last", "image/jpeg", true, this::view);
    }

    private Picture.View view() {
        MarkerCamera last = camera;
        CameraHealth health = last == null ? UNUSED : last.newest().health();
        boolean isOpen = health.state() != CameraHealth.Condition.CLOSED;
        String trouble = isOpen ? health.reason() : "";
        return preview.newest()
                .map(shot -> new Picture.View(shot.jpeg(), note(shot.age(), isOpen, trouble)))
                .orElseGet(() -> new Picture.View(new byte[0], isOpen ? said("No picture yet", trouble) : NO_PICTURE));
    }

    private static String note(Duration age, boolean isOpen, String trouble) {
        String taken = "Taken " + ago(age);
        if (!isOpen) {
            return taken + ". The next picture is taken when Move drives the robot.";
        }
        return trouble.isEmpty() && age.compareTo(LIVE) < 0 ? taken + "." : said(taken, trouble);
    }

    private static String said(String what, String trouble) {
        return trouble.isEmpty() ? what + "." : what + ": " + trouble + ".";
    }

    private static String ago(Duration age) {
        if (age.toMinutes() == 0) {
            return String.format(Locale.ROOT, "%.1f s ago", age.toMillis() / 1000.0);
        }
        return age.toHours() == 0
                ? age.toMinutes() + " min ago"
                : age.toHours() + " h " + age.toMinutesPart() + " min ago";
    }
}
