package org.evoloop.benchmarks.device;

import org.HdrHistogram.Histogram;
import org.evoloop.roomba.link.Link;
import org.evoloop.roomba.link.LinkException;
import org.evoloop.roomba.link.WakeLine;
import org.jspecify.annotations.Nullable;

/**
 * A link that measures from when the byte that completes a frame was read to when the operating system has taken a
 * command that answers it.
 *
 * <p>Threading: as {@link Link}.
 */
final class TimedLink implements Link {
    private static final int CLEAN = 135;

    private final Link link;
    private final Histogram nanos;
    private volatile long receivedNanos;

    /** Measures {@code link} into {@code nanos}. */
    TimedLink(Link link, Histogram nanos) {
        this.link = link;
        this.nanos = nanos;
    }

    @Override
    public int receive(byte[] buffer) {
        int length = link.receive(buffer);
        receivedNanos = System.nanoTime();
        return length;
    }

    @Override
    public @Nullable LinkException loss() {
        return link.loss();
    }

    @Override
    public void send(byte[] bytes) {
        link.send(bytes);
        if (bytes.length == 1 && (bytes[0] & 0xFF) == CLEAN) {
            nanos.recordValue(System.nanoTime() - receivedNanos);
        }
    }

    @Override
    public WakeLine wakeLine() {
        return link.wakeLine();
    }

    @Override
    public String description() {
        return link.description();
    }

    @Override
    public void close() {
        link.close();
    }
}
