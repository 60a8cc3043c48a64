package org.evoloop.link;

/**
 * An output of the link that wakes a sleeping device by going low for a while; at rest it is high. How long, the caller
 * knows from the device's specification.
 *
 * @since 0.1
 */
@FunctionalInterface
public interface WakeLine {
    /** For links that have no such line. */
    WakeLine NONE = low -> false;

    /**
     * Pulls the line low, or lets it go high again.
     *
     * @return whether the line did; false if there is none, as on a pseudo-terminal, or the link is not open
     */
    boolean setLow(boolean low);
}
