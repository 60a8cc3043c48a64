package org.evoloop.link;

/**
 * An output of the link that wakes a sleeping device by going low for a while; at rest it is high. The caller takes the
 * required time from the device's specification.
 *
 * @since 0.1
 */
@FunctionalInterface
public interface WakeLine {
    /** For links without such a line. */
    WakeLine NONE = low -> false;

    /**
     * Sets the line low or high.
     *
     * @return whether that worked; false if there is no line, as on a pseudo-terminal, or the link is not open
     */
    boolean setLow(boolean low);
}
