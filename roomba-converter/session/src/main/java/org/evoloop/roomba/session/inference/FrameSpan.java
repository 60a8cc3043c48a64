package org.evoloop.roomba.session.inference;

/**
 * A span of time, counted in frames of the stream, one every 15 ms. After the computer has paused, old frames come all
 * at once; so a span also needs most of its time on the clock.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class FrameSpan {
    /** Three quarters of the time between two frames: the robot's clock may be faster than this computer's. */
    private static final long LEAST_NANOS_PER_FRAME = 11_250_000;

    private int frames;
    private long firstNanos;
    private long lastNanos;

    /** A span that begins with the next frame. */
    public FrameSpan() {}

    /** The next frame is the first one. */
    public void restart() {
        frames = 0;
    }

    /**
     * A frame was received.
     *
     * @param nowNanos the time on a monotonic clock
     */
    public void count(long nowNanos) {
        if (frames++ == 0) {
            firstNanos = nowNanos;
        }
        lastNanos = nowNanos;
    }

    /** Whether it has lasted for {@code wanted} frames. */
    public boolean hasLasted(int wanted) {
        return frames >= wanted && lastNanos - firstNanos >= wanted * LEAST_NANOS_PER_FRAME;
    }
}
