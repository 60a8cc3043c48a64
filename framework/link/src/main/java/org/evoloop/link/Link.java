package org.evoloop.link;

import org.jspecify.annotations.Nullable;

/**
 * The cable between the converter and a device.
 *
 * <pre>
 *  open --close--&gt; closed
 *    \-----loss--&gt; lost
 * </pre>
 *
 * <p>A link cannot be reopened, and is open from the start: after a loss the owner makes another one. When {@link
 * #receive} reports a loss, the link has released all resources, so that the next link to the same device can be opened
 * at once.
 *
 * <p>Threading: one thread receives; the other methods may be called from any thread, including that one.
 *
 * @since 0.1
 */
public interface Link extends AutoCloseable {
    /** The result of {@link #receive} when there is nothing more to come. */
    int ENDED = -1;

    /**
     * Waits for bytes, which arrive in order and in arbitrary portions.
     *
     * @param buffer receives the bytes from its start on
     * @return the number of bytes; 0 only from a link that does not wait, when there are none; {@link #ENDED} once the
     *     link is closed or lost, see {@link #loss}
     */
    int receive(byte[] buffer);

    /** The reason for the loss; null while the link is open, or if {@link #close} has ended it. */
    @Nullable
    LinkException loss();

    /**
     * Sends bytes; those of one call stay together. Returns when the operating system has accepted all of them. An
     * interrupt does not cut it short, because threads that are being stopped send the commands that leave a device
     * safe.
     *
     * @throws LinkException if not all bytes could be sent; the link is lost or was closed
     */
    void send(byte[] bytes);

    /** The line that wakes the device. It has no effect unless the link is open. */
    WakeLine wakeLine();

    /** A description of the link, for messages. */
    String description();

    /** Ends the link after the bytes that were sent have left. Later calls do nothing. Bounded, never throws. */
    @Override
    void close();
}
