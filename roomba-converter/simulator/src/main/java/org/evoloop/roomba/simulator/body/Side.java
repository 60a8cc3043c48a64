package org.evoloop.roomba.simulator.body;

/**
 * A side of the robot, as seen in the direction of travel.
 *
 * @since 0.1
 */
public enum Side {
    /** The left. */
    LEFT,
    /** The right. */
    RIGHT
}
