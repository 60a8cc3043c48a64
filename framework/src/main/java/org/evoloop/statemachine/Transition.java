package org.evoloop.statemachine;

/**
 * One element of T: in {@code source}, {@code event} leads to {@code target}.
 *
 * <p>Threading: immutable.
 */
public record Transition(State source, Event event, State target) {

    /** For messages: {@code Off --Clean--> On}. */
    @Override
    public String toString() {
        return source + " --" + event + "--> " + target;
    }
}
