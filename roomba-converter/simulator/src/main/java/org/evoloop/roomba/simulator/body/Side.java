package org.evoloop.roomba.simulator.body;

/**
 * Of the robot, as seen by somebody who sits on it.
 *
 * @since 0.1
 */
public enum Side {
    /** The left. */
    LEFT,
    /** The right. */
    RIGHT
}
