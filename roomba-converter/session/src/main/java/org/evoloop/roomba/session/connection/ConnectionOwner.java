package org.evoloop.roomba.session.connection;

import org.evoloop.link.Link;

/**
 * Interprets the bytes of the robot at the other end of a {@link Connection}.
 *
 * @since 0.1
 */
public interface ConnectionOwner {
    /**
     * Reads {@code link}, from the first byte on, and tells {@link Connection#answered} of each frame. Returns when
     * nothing more comes: when the link has ended, or, if it does not wait, for now. Called on the thread that reads.
     */
    void read(Link link);

    /** The robot is out of sight. Called on the thread that reads or on the connection's own. */
    void outOfSight();

    /** What is known of whatever answers. */
    FirstBytes firstBytes();

    /** What is wrong with the frames that come, if that is known; else empty. */
    String frameTrouble();

    /** Whether the robot may be kept awake by a pulse now: it is on its own and does nothing. */
    boolean isDozing();

    /** Whether a robot that is silent now has fallen asleep, as it does when nobody uses it. */
    boolean isDrowsy();

    /** The robot has fallen asleep. Called on the connection's own thread. */
    void fellAsleep();

    /** The robot was kept awake. Called on the connection's own thread. */
    void keptAwake();
}
