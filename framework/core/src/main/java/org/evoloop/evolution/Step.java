package org.evoloop.evolution;

import java.util.List;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;

/**
 * One transition of the original model in a decision.
 *
 * <p>Threading: immutable.
 *
 * @param transition a transition of the original model; the device runs its effects
 * @param trigger the event without its guards, which is what is sent
 * @param byDevice true if the device took the step itself, so that nothing is sent for it
 * @param conditional whether guards decide that the trigger takes this transition; they are evaluated before it is sent
 * @since 0.1
 */
public record Step(Transition transition, Event trigger, boolean byDevice, boolean conditional) {
    Step(Transition transition, boolean byDevice, boolean conditional) {
        this(transition, transition.event().trigger(), byDevice, conditional);
    }

    /** The device's state before. */
    public State source() {
        return transition.source();
    }

    /** The event, with its guards; {@link Event#name} is what is sent. */
    public Event event() {
        return transition.event();
    }

    /** The device's state after. */
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
