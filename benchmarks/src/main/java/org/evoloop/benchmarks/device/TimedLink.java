package org.evoloop.benchmarks.device;

import org.HdrHistogram.Histogram;
import org.evoloop.link.ForwardingLink;
import org.evoloop.link.Link;

/**
 * Measures the time from reading the byte that completes a frame until the operating system has accepted the command
 * that answers it.
 *
 * <p>Threading: as {@link Link}.
 */
final class TimedLink extends ForwardingLink {
    private static final int CLEAN = 135;

    private final Histogram nanos;
    private volatile long receivedNanos;

    /** Measures {@code link} into {@code nanos}. */
    TimedLink(Link link, Histogram nanos) {
        super(link);
        this.nanos = nanos;
    }

    @Override
    public int receive(byte[] buffer) {
        int length = super.receive(buffer);
        receivedNanos = System.nanoTime();
        return length;
    }

    @Override
    public void send(byte[] bytes) {
        super.send(bytes);
        if (bytes.length == 1 && (bytes[0] & 0xFF) == CLEAN) {
            nanos.recordValue(System.nanoTime() - receivedNanos);
        }
    }
}
