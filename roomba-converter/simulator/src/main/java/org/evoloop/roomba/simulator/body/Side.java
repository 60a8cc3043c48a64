package org.evoloop.roomba.simulator.body;

/** Of the robot, as seen by somebody who sits on it. */
public enum Side {
    LEFT,
    RIGHT
}
