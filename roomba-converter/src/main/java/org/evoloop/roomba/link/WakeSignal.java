package org.evoloop.roomba.link;

/**
 * Which output of the serial adapter is wired to the robot's BRC pin. Cables differ: iRobot's own uses RTS, others DTR,
 * and some that should use RTS are miswired.
 */
public enum WakeSignal {
    RTS,
    DTR,
    /** Both together, for a cable nobody knows. */
    BOTH
}
