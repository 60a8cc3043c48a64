package org.evoloop.roomba;

/** The names that the models of the cleaning robot and this program have in common (paper, section VI.A). */
final class RobotEvents {
    static final String CLEAN = "Clean";
    static final String SPOT = "Spot";
    static final String END_SPOT = "endSpot";
    static final String TIMEOUT = "timeout";

    /** The robot stands by: its light is off, and CLEAN switches it on. */
    static final String STATE_OFF = "Off";

    /** The robot is on and does nothing. */
    static final String STATE_ON = "On";

    static final String STATE_CLEAN = "Clean";
    static final String STATE_SPOT = "Spot";
    static final String STATE_MOVE = "Move";
    static final String STATE_SPOT_WAIT = "SpotWait";

    private RobotEvents() {}
}
