package org.evoloop.roomba.camera.live;

import java.time.Duration;
import java.util.Optional;
import org.evoloop.roomba.camera.vision.Frame;
import org.evoloop.roomba.camera.vision.Vision;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * The last picture of a camera, for people: a small JPEG, encoded only while somebody requests it. It outlives the
 * cameras whose frames it shows.
 *
 * <p>Threading: thread-safe; the frames come from one thread at a time.
 *
 * @since 0.1
 */
public final class CameraPreview {
    /** Long enough for a viewer that requests a picture once a second and is late. */
    private static final Duration WANTED_FOR = Duration.ofSeconds(3);

    private static final Duration BETWEEN = Duration.ofMillis(250);
    private static final int MOST_WIDTH_PX = 640;

    private final Vision vision;
    private final Clock clock;
    private volatile long wantedUntilNanos;
    private volatile @Nullable Made last;

    @SuppressWarnings("ArrayRecordComponent") // The bytes are never changed.
    private record Made(byte[] jpeg, long nanos) {}

    /**
     * A picture.
     *
     * @param jpeg at most 640 px wide; must not be changed
     * @param age the time since the camera's thread received it
     */
    @SuppressWarnings("ArrayRecordComponent") // Viewers get the bytes without a copy.
    public record Shot(byte[] jpeg, Duration age) {}

    /** @param clock the viewers' clock, in real time */
    public CameraPreview(Vision vision, Clock clock) {
        this.vision = vision;
        this.clock = clock;
        wantedUntilNanos = clock.nanoTime();
    }

    /** The last picture, if there is one; keeps encoding on for the next 3 s. Never blocks. */
    public Optional<Shot> newest() {
        long now = clock.nanoTime();
        wantedUntilNanos = now + WANTED_FOR.toNanos();
        return Optional.ofNullable(last).map(made -> new Shot(made.jpeg(), Duration.ofNanos(now - made.nanos())));
    }

    /** Encodes the frame if a picture is wanted and the last is at least 250 ms old. */
    public void offer(Frame frame) {
        long now = clock.nanoTime();
        Made made = last;
        if (now - wantedUntilNanos < 0 && (made == null || now - made.nanos() >= BETWEEN.toNanos())) {
            last = new Made(vision.jpeg(frame, MOST_WIDTH_PX), now);
        }
    }
}
