package org.evoloop.evolution;

import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/**
 * One transition of the original model on the way of a decision.
 *
 * <p>Threading: immutable.
 *
 * @param source where the device is before
 * @param event what takes it on
 * @param target where the device is after
 * @param byDevice true if the device took the step itself, so that nothing is sent for it
 */
public record Step(State source, Event event, State target, boolean byDevice) {

    /** For messages: {@code Clean --Clean--> On}. */
    @Override
    public String toString() {
        return source + " --" + event + "--> " + target + (byDevice ? " (by the device)" : "");
    }
}
