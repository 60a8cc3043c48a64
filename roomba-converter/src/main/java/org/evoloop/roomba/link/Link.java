package org.evoloop.roomba.link;

/**
 * The cable between the converter and the robot.
 *
 * <pre>
 *  new --open--&gt; open --close--&gt; closed
 *                  \---loss----&gt; closed
 * </pre>
 *
 * <p>A link lives once: after a loss the owner makes another one. When the receiver hears of the loss everything the
 * link held has been given back, so that the next link to the same robot can be opened at once.
 *
 * <p>Threading: every method may be called from any thread, also from within the receiver.
 */
public interface Link extends AutoCloseable {

    /** What the owner of a link is told, one call at a time. It must not throw. */
    interface Receiver {
        /**
         * Bytes have come, in order and cut anywhere.
         *
         * @param buffer valid during the call only
         * @param length how many of them, from the buffer's start
         */
        void received(byte[] buffer, int length);

        /** The link is lost, not by {@link Link#close()}. This is the last call. */
        void lost(LinkException cause);
    }

    /**
     * Starts to receive.
     *
     * @throws LinkException if the cable cannot be used; the link remains new
     * @throws IllegalStateException if the link has been opened or closed before
     */
    void open(Receiver receiver);

    /**
     * Sends bytes; those of one call stay together. Returns when the operating system has taken all of them. An
     * interrupt does not cut it short: what makes a robot safe is sent by threads that are being stopped.
     *
     * @throws LinkException if not all bytes could be sent; the link is lost or was not open
     */
    void send(byte[] bytes);

    /** The line that wakes the robot. Without effect unless the link is open. */
    WakeLine wakeLine();

    /** The link in words, for messages. */
    String description();

    /** Ends the link after the bytes that were sent have left. Later calls do nothing. Bounded, never throws. */
    @Override
    void close();
}
