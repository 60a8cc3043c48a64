package org.evoloop.roomba.link;

/**
 * The line to the robot's BRC pin ("device detect"). A sleeping robot wakes when it goes low for a while; at rest it is
 * high. The caller decides how long, with one warning: three pulses of 50 to 500 ms after power-on switch a Roomba to
 * 19200 baud (Open Interface specification, "Serial Port Settings").
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
