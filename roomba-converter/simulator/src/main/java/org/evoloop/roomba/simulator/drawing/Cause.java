package org.evoloop.roomba.simulator.drawing;

import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.simulator.robot.RobotState;

/** Why the robot moves. */
enum Cause {
    CLEAN("cleans", "#2f9e44"),
    SPOT("spot cleans", "#e8590c"),
    DOCK("seeks its dock", "#1971c2"),
    CLIENT("driven by a program", "#9c36b5");

    private final String label;
    private final String color;

    Cause(String label, String color) {
        this.label = label;
        this.color = color;
    }

    /** Why the robot moves now; the earlier cause while it is only coming to rest. */
    static Cause of(RobotState state, Cause earlier) {
        return switch (state.activity()) {
            case CLEAN -> CLEAN;
            case SPOT -> SPOT;
            case DOCK -> DOCK;
            case OFF, ON -> state.oiMode() == OiMode.SAFE || state.oiMode() == OiMode.FULL ? CLIENT : earlier;
        };
    }

    String label() {
        return label;
    }

    String color() {
        return color;
    }
}
