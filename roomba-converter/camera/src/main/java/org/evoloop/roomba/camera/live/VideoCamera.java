package org.evoloop.roomba.camera.live;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.evoloop.roomba.camera.Belief;
import org.evoloop.roomba.camera.CameraException;
import org.evoloop.roomba.camera.CameraHealth;
import org.evoloop.roomba.camera.Look;
import org.evoloop.roomba.camera.MarkerCamera;
import org.evoloop.roomba.camera.Sighting;
import org.evoloop.roomba.camera.vision.Detection;
import org.evoloop.roomba.camera.vision.Frame;
import org.evoloop.roomba.camera.vision.FrameRecorder;
import org.evoloop.roomba.camera.vision.MarkerFinder;
import org.evoloop.roomba.camera.vision.Vision;
import org.evoloop.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A camera with two daemon threads: {@code evoloop-camera} owns the source and reads all frames, {@code evoloop-eye}
 * looks for the marker in the newest one. Even if that is slow, frames do not queue up in a driver or server.
 *
 * <p>A missing source is not an error: opening it is retried, and {@link Look#health} reports it. Threading:
 * thread-safe.
 *
 * @since 0.1
 */
public final class VideoCamera implements MarkerCamera {
    private static final Logger LOG = LoggerFactory.getLogger(VideoCamera.class);

    private static final long CLOSE_LIMIT_NANOS = TimeUnit.SECONDS.toNanos(2);
    private static final int RECORDED_FRAMES_PER_SECOND = 15;

    private final CameraSettings settings;
    private final Clock clock;
    private final HealthTracker health;
    private final NewestFrame frames;
    private final Grabber grabber;
    private final MarkerFinder finder;
    private final Optional<FrameRecorder> recorder;
    private final Belief belief;
    private final Consumer<Frame> viewer;
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
    private final Thread reading;
    private final Thread looking;

    private volatile Look last = new Look(0, 0, CameraHealth.SEEING, Optional.empty());
    private final AtomicLong detections = new AtomicLong();

    /**
     * The counts of a camera.
     *
     * @param looked processed frames
     * @param detections the processed frames that showed the marker
     * @param damaged unusable frames
     */
    public record Counts(long looked, long detections, long damaged) {}

    private VideoCamera(Vision vision, CameraSettings settings, Clock clock, Consumer<Frame> viewer) {
        this.settings = settings;
        this.clock = clock;
        this.viewer = viewer;
        // The frame rate of a recording is unknown, so it never counts as stalled.
        Duration staleAfter = settings.source().isLive() ? settings.staleAfter() : Duration.ofDays(365);
        health = new HealthTracker("camera " + settings.source(), staleAfter);
        frames = new NewestFrame(vision::newFrame, !settings.source().isLive());
        grabber = new Grabber(
                settings.source(), () -> vision.open(settings.source(), settings.size()), clock, health, frames);
        finder = vision.finder(settings.marker(), settings.model());
        recorder = settings.record()
                .map(file -> vision.recorder(file, RECORDED_FRAMES_PER_SECOND, settings.recordLimitBytes()));
        belief = new Belief(settings.framesInARow());
        reading = daemon("evoloop-camera", grabber);
        looking = daemon("evoloop-eye", this::look);
    }

    /** Starts opening the source and looking for the marker; returns at once. */
    public static VideoCamera open(Vision vision, CameraSettings settings, Clock clock) {
        return open(vision, settings, clock, frame -> {});
    }

    /**
     * Opens a camera with a viewer.
     *
     * @param viewer receives each frame after it was processed, on the camera's thread; the frame is valid until it
     *     returns
     */
    public static VideoCamera open(Vision vision, CameraSettings settings, Clock clock, Consumer<Frame> viewer) {
        VideoCamera camera = new VideoCamera(vision, settings, clock, viewer);
        camera.reading.start();
        camera.looking.start();
        return camera;
    }

    private static Thread daemon(String name, Runnable task) {
        Thread thread = new Thread(
                () -> {
                    Background.begin();
                    task.run();
                },
                name);
        thread.setDaemon(true);
        return thread;
    }

    private void look() {
        try {
            while (true) {
                NewestFrame.Taken taken = frames.take();
                try {
                    look(taken);
                    show(taken.frame());
                } finally {
                    frames.giveBack(taken.frame());
                }
                listeners.forEach(Runnable::run);
            }
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
        } finally {
            finder.close();
            recorder.ifPresent(FrameRecorder::close);
        }
    }

    private void look(NewestFrame.Taken taken) {
        try {
            Optional<Detection> seen = finder.detect(taken.frame());
            if (seen.isPresent()) {
                detections.incrementAndGet();
            }
            Optional<Sighting> believed = belief.after(seen.map(Detection::sighting));
            health.seeing(taken.nanos());
            last = new Look(last.frame() + 1, taken.nanos(), CameraHealth.SEEING, believed);
            recorder.ifPresent(
                    to -> to.write(taken.frame(), taken.nanos(), seen, captions(taken.nanos(), seen, believed)));
        } catch (CameraException notForThisCamera) {
            health.blind(notForThisCamera.getMessage());
        } catch (RuntimeException failed) {
            LOG.error("looking at a frame of camera {} failed", settings.source(), failed);
            health.blind("looking at what camera " + settings.source() + " sends fails: " + failed);
        }
    }

    /** A failing viewer must not stop the camera. */
    private void show(Frame frame) {
        try {
            viewer.accept(frame);
        } catch (RuntimeException failed) {
            LOG.error("the picture of camera {} cannot be shown", settings.source(), failed);
        }
    }

    private List<String> captions(long takenNanos, Optional<Detection> seen, Optional<Sighting> believed) {
        String age = String.format(
                Locale.ROOT, "frame %d, %d ms old", last.frame(), (clock.nanoTime() - takenNanos) / 1_000_000);
        return seen.map(detection -> List.of(
                        age,
                        String.format(
                                Locale.ROOT,
                                "marker %d: %.0f mm, %+.1f deg%s",
                                detection.id(),
                                detection.sighting().distanceMm(),
                                Math.toDegrees(detection.sighting().bearingRad()),
                                believed.isPresent() ? "" : " (not yet believed)")))
                .orElse(List.of(age));
    }

    @Override
    public Look newest() {
        Look seen = last;
        return new Look(seen.frame(), seen.takenNanos(), health.at(clock.nanoTime()), seen.sighting());
    }

    /** The counts so far. */
    public Counts counts() {
        return new Counts(last.frame(), detections.get(), grabber.damagedFrames());
    }

    @Override
    public Runnable onLook(Runnable listener) {
        // A new object for each registration, so that the same listener can be registered twice.
        Runnable registered = () -> {
            try {
                listener.run();
            } catch (RuntimeException failed) {
                LOG.error("a listener to the camera failed", failed);
            }
        };
        listeners.add(registered);
        return () -> listeners.remove(registered);
    }

    @Override
    public void close() {
        grabber.stop();
        health.closed();
        frames.close();
        reading.interrupt();
        looking.interrupt();
        long deadline = System.nanoTime() + CLOSE_LIMIT_NANOS;
        for (Thread thread : List.of(looking, reading)) {
            if (thread != Thread.currentThread()) {
                join(thread, deadline);
            }
        }
    }

    private void join(Thread thread, long deadline) {
        try {
            TimeUnit.NANOSECONDS.timedJoin(thread, Math.max(1, deadline - System.nanoTime()));
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
        }
        if (thread.isAlive()) {
            LOG.warn(
                    "thread {} of camera {} waits in its driver; it ends when that returns",
                    thread.getName(),
                    settings.source());
        }
    }
}
