package org.evoloop.converter;

import org.evoloop.function.NewFunction;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/**
 * A transition of the new model as registered in the knowledge (paper, section V.B): the current state, the incoming
 * event, the next state, and the function to call.
 *
 * <p>Threading: immutable.
 *
 * @param action the function that runs in {@code target}; {@link NewFunction#none()} where the device does the work
 * @since 0.1
 */
public record BoundTransition(State source, Event event, State target, NewFunction action) {}
