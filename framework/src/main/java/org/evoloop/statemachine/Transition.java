package org.evoloop.statemachine;

import java.util.List;

/**
 * One element of T: in {@code source}, {@code event} leads to {@code target}.
 *
 * <p>Threading: immutable.
 *
 * @param effects names of the behaviors that run when it is taken, in order: those on leaving states, its own, and those
 *     on entering states
 * @param internal whether the state is neither left nor entered, so that its timers and its function go on; then source
 *     and target are the same
 */
public record Transition(State source, Event event, State target, List<String> effects, boolean internal) {

    /** @throws ModelException if it is internal and leads elsewhere */
    public Transition {
        effects = List.copyOf(effects);
        if (internal && !source.equals(target)) {
            throw new ModelException("the internal transition on " + event + " leads from " + source + " to " + target
                    + "; end it where it begins");
        }
    }

    /** A transition without effects. */
    public Transition(State source, Event event, State target) {
        this(source, event, target, List.of(), false);
    }

    /** For messages: {@code Off --Clean--> On}. */
    @Override
    public String toString() {
        return source + " --" + event + "--> " + target;
    }
}
