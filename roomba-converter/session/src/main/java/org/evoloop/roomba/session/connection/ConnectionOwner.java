package org.evoloop.roomba.session.connection;

import org.evoloop.link.Link;

/**
 * Interprets the bytes of the robot at the other end of a {@link RobotConnection}.
 *
 * @since 0.1
 */
public interface ConnectionOwner {
    /**
     * Reads {@code link} from the first byte on, and calls {@link RobotConnection#answered} for each frame. Returns when the
     * link has ended or, if it does not wait, when no more bytes are available. Called on the reading thread.
     */
    void read(Link link);

    /** The robot is unreachable. Called on the reading thread or the connection's own. */
    void outOfSight();

    /** The first bytes received, which help to identify the device. */
    FirstBytes firstBytes();

    /** The problem with the received frames, if known; else empty. */
    String frameTrouble();

    /** Whether the robot may be kept awake by a pulse now: it is not under control and is idle. */
    boolean isDozing();

    /** Whether a robot that is silent now has fallen asleep, as an unused robot does. */
    boolean isDrowsy();

    /** The robot has fallen asleep. Called on the connection's own thread. */
    void fellAsleep();

    /** The robot was kept awake. Called on the connection's own thread. */
    void keptAwake();
}
