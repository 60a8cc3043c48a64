package org.evoloop.evolution;

import java.time.Duration;
import java.util.Map;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/**
 * The timers of the states of a new model.
 *
 * <p>Threading: a pure function, which any thread may call.
 *
 * @since 0.1
 */
@FunctionalInterface
public interface Timers {
    /** The timer events of {@code state}, with their delays. */
    Map<Event, Duration> of(State state);

    /** The timers drawn in {@code machine}. */
    static Timers drawnIn(StateMachine machine) {
        return machine::timers;
    }
}
