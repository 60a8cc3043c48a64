package org.evoloop.evolution;

import java.util.List;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;

/**
 * One transition of the original model on the way of a decision.
 *
 * <p>Threading: immutable.
 *
 * @param transition of the original model; the device carries its effects out
 * @param trigger the event without its guards, which is what is sent
 * @param byDevice true if the device took the step itself, so that nothing is sent for it
 * @param conditional whether guards decide that the trigger leads this way; they are asked before it is sent
 * @since 0.1
 */
public record Step(Transition transition, Event trigger, boolean byDevice, boolean conditional) {
    Step(Transition transition, boolean byDevice, boolean conditional) {
        this(transition, transition.event().trigger(), byDevice, conditional);
    }

    /** Where the device is before. */
    public State source() {
        return transition.source();
    }

    /** What takes it on, with its guards; {@link Event#name} is what is sent. */
    public Event event() {
        return transition.event();
    }

    /** Where the device is after. */
    public State target() {
        return transition.target();
    }

    /** What the device does by itself on this step, as drawn. */
    public List<String> effects() {
        return transition.effects();
    }

    /** For messages: {@code Clean --Clean--> On}. */
    @Override
    public String toString() {
        return transition + (byDevice ? " (by the device)" : "");
    }
}
