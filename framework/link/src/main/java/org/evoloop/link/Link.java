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
 * <p>A link lives once, and is open from the start: after a loss the owner makes another one. When {@link #receive} tells
 * of the loss everything the link held has been given back, so that the next link to the same device can be opened at
 * once.
 *
 * <p>Threading: one thread receives; the other methods may be called from any thread, including that one.
 *
 * @since 0.1
 */
public interface Link extends AutoCloseable {
    /** What {@link #receive} returns when there is nothing more to come. */
    int ENDED = -1;

    /**
     * Waits for bytes; they come in order and cut anywhere.
     *
     * @param buffer takes the bytes from its start on
     * @return how many have come; 0 only from a link that does not wait, when there are none; {@link #ENDED} once the
     *     link is closed or lost, see {@link #loss}
     */
    int receive(byte[] buffer);

    /** Why the link is lost; null while it is open, and if {@link #close} has ended it. */
    @Nullable
    LinkException loss();

    /**
     * Sends bytes; those of one call stay together. Returns when the operating system has taken all of them. An
     * interrupt does not cut it short: what leaves a device safe is sent by threads that are being stopped.
     *
     * @throws LinkException if not all bytes could be sent; the link is lost or was closed
     */
    void send(byte[] bytes);

    /** The line that wakes the device. Without effect unless the link is open. */
    WakeLine wakeLine();

    /** The link in words, for messages. */
    String description();

    /** Ends the link after the bytes that were sent have left. Later calls do nothing. Bounded, never throws. */
    @Override
    void close();
}
