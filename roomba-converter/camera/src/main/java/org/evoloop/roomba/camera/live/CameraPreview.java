package org.evoloop.roomba.camera.live;

import java.time.Duration;
import java.util.Optional;
import org.evoloop.roomba.camera.vision.Frame;
import org.evoloop.roomba.camera.vision.Vision;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * What a camera saw last, for people: a small JPEG, made only while somebody asks for it. It outlives the cameras that
 * show it their frames.
 *
 * <p>Threading: thread-safe; the frames come from one thread at a time.
 *
 * @since 0.1
 */
public final class CameraPreview {
    /** A viewer who asks once a second may miss a turn. */
    private static final Duration WANTED_FOR = Duration.ofSeconds(3);

    private static final Duration BETWEEN = Duration.ofMillis(250);
    private static final int MOST_WIDTH_PX = 640;

    private final Vision vision;
    private final Clock clock;
    private volatile long wantedUntilNanos;
    private volatile @Nullable Made last;

    @SuppressWarnings("ArrayRecordComponent") // Nobody changes them.
    private record Made(byte[] jpeg, long nanos) {}

    /**
     * A picture.
     *
     * @param jpeg at most 640 px wide; not to be changed
     * @param age the time since the camera's thread had it
     */
    @SuppressWarnings("ArrayRecordComponent") // The bytes go to viewers as they are.
    public record Shot(byte[] jpeg, Duration age) {}

    /** @param clock of the viewers, in real time */
    public CameraPreview(Vision vision, Clock clock) {
        this.vision = vision;
        this.clock = clock;
        wantedUntilNanos = clock.nanoTime();
    }

    /** The last picture, if there is one; has pictures made for the next 3 s. Never waits. */
    public Optional<Shot> newest() {
        long now = clock.nanoTime();
        wantedUntilNanos = now + WANTED_FOR.toNanos();
        return Optional.ofNullable(last).map(made -> new Shot(made.jpeg(), Duration.ofNanos(now - made.nanos())));
    }

    /** Makes a picture of the frame if one is wanted and the last is at least 250 ms old. */
    public void offer(Frame frame) {
        long now = clock.nanoTime();
        Made made = last;
        if (now - wantedUntilNanos < 0 && (made == null || now - made.nanos() >= BETWEEN.toNanos())) {
            last = new Made(vision.jpeg(frame, MOST_WIDTH_PX), now);
        }
    }
}
