package org.evoloop.check.temporal;

import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.jspecify.annotations.Nullable;

/**
 * The observable state of a running converter between two events.
 *
 * <p>Threading: immutable.
 *
 * @param at the states of both models
 * @param last the event that has led here, without its guards; null at the start
 * @since 0.1
 */
public record Moment(Configuration at, @Nullable Event last) {

    /** Whether {@code atom} holds. */
    public boolean shows(Formula.Atom atom, ModelPair pair) {
        return switch (atom.kind()) {
            case STATE -> isCalled(atom.name(), at.evolved(), pair.evolved());
            case DEVICE -> isCalled(atom.name(), at.original(), pair.original());
            case EVENT -> last != null && last.name().equals(atom.name());
            case FUNCTION -> isCalled(atom.name(), at.evolved(), pair.evolved()) && pair.isNew(at.evolved());
        };
    }

    /** Compares with and without the history that the machine remembers. */
    private static boolean isCalled(String name, State state, StateMachine machine) {
        return state.name().equals(name) || machine.withoutMemory(state).name().equals(name);
    }
}
