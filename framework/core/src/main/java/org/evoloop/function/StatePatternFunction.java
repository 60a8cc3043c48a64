package org.evoloop.function;

import org.jspecify.annotations.Nullable;

/**
 * A new function whose state is composite: it passes through sub-states, each a concrete state of the state pattern
 * (paper, section V.B).
 *
 * <p>Threading: as {@link NewFunction}; all sub-states of a visit run on its one thread.
 *
 * @since 0.1
 */
public final class StatePatternFunction implements NewFunction {

    /** A sub-state. */
    @FunctionalInterface
    public interface SubState {
        /**
         * Performs the sub-state.
         *
         * @return the next one, or null if the function is done
         * @throws Exception as {@link NewFunction#run}
         */
        @Nullable
        SubState perform(Visit visit) throws Exception;
    }

    private final SubState initial;

    /** @param initial where each visit starts */
    public StatePatternFunction(SubState initial) {
        this.initial = initial;
    }

    @Override
    public void run(Visit visit) throws Exception {
        SubState current = initial;
        while (current != null && visit.isActive()) {
            current = current.perform(visit);
        }
    }
}
