package org.evoloop.roomba;

import java.util.Arrays;
import java.util.Optional;
import org.evoloop.roomba.move.Move;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/** A function that this program can run in a new state, by the name that {@code --function} knows it by. */
enum RobotFunction {
    /** Drives to the starting point, and raises {@code arriveSpot} there. */
    MOVE("Move", Move.ARRIVED),

    /** Waits for a second press, and raises {@code timeout}; a time trigger of the model does the same by itself. */
    SPOT_WAIT("SpotWait", RobotEvents.TIMEOUT),

    /** Has the robot clean the spot where it is; the robot tells the end. */
    SPOT_CLEAN("SpotClean", ""),

    /** Has the robot dock; the robot tells when it is charged. */
    CHARGE("Charge", ""),

    /** Waits for the end of the quiet hours, and raises {@code quietOver}. */
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

    /** The event that it finishes with; empty if it raises none. */
    String lastEvent() {
        return lastEvent;
    }

    /** Whether the event that it finishes with leaves {@code state}. */
    boolean finishesIn(StateMachine evolved, State state) {
        return evolved.hasTrigger(state, new Event(lastEvent));
    }

    @Override
    public String toString() {
        return id;
    }
}
