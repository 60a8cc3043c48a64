package org.evoloop.roomba;

import java.util.Arrays;
import java.util.Optional;
import org.evoloop.roomba.move.Move;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/** A function that this program can run in a new state; its name is used by {@code --function}. */
enum RobotFunction {
    /** Drives to the starting point and raises {@code arriveSpot} there. */
    MOVE("Move", Move.ARRIVED),

    /**
     * Waits for a second press, then raises {@code timeout}; a time trigger in the model does the same without a
     * function.
     */
    SPOT_WAIT("SpotWait", RobotEvents.TIMEOUT),

    /** Makes the robot clean the spot where it is; the robot reports the end. */
    SPOT_CLEAN("SpotClean", ""),

    /** Makes the robot dock; the robot reports when it is charged. */
    CHARGE("Charge", ""),

    /** Waits until the quiet hours end and raises {@code quietOver}. */
    QUIET_HOURS("QuietHours", RobotEvents.QUIET_OVER),

    /** Nothing runs; the state waits for an event. */
    NONE("none", "");

    static final String NAMES = "Move, SpotWait, SpotClean, Charge, QuietHours and none";

    private final String id;
    private final String lastEvent;

    RobotFunction(String id, String lastEvent) {
        this.id = id;
        this.lastEvent = lastEvent;
    }

    static Optional<RobotFunction> of(String name) {
        return Arrays.stream(values())
                .filter(function -> function.id.equals(name))
                .findFirst();
    }

    /** The event with which it finishes; empty if it raises none. */
    String lastEvent() {
        return lastEvent;
    }

    /** Whether that event leaves {@code state}. */
    boolean finishesIn(StateMachine evolved, State state) {
        return evolved.hasTrigger(state, new Event(lastEvent));
    }

    @Override
    public String toString() {
        return id;
    }
}
