package org.evoloop.evolution;

import java.time.Duration;
import java.util.Map;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/**
 * What is raised by itself in the states of a new model.
 *
 * <p>Threading: a pure function, which any thread may call.
 *
 * @since 0.1
 */
@FunctionalInterface
public interface Timers {
    /** Every event that is raised by itself in {@code state}, and after how long. */
    Map<Event, Duration> of(State state);

    /** Those that are drawn in {@code machine}. */
    static Timers drawnIn(StateMachine machine) {
        return machine::timers;
    }
}
