package org.evoloop.check.temporal;

import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.jspecify.annotations.Nullable;

/**
 * What is known of a running converter between two events.
 *
 * <p>Threading: immutable.
 *
 * @param at where both models stand
 * @param last the event that has led here, without its guards; null at the start
 * @since 0.1
 */
public record Moment(Configuration at, @Nullable Event last) {

    /** Whether {@code atom} is so. */
    public boolean shows(Formula.Atom atom, ModelPair pair) {
        return switch (atom.kind()) {
            case STATE -> isCalled(atom.name(), at.evolved(), pair.evolved());
            case DEVICE -> isCalled(atom.name(), at.original(), pair.original());
            case EVENT -> last != null && last.name().equals(atom.name());
            case FUNCTION -> isCalled(atom.name(), at.evolved(), pair.evolved()) && pair.isNew(at.evolved());
        };
    }

    /** With what the machine remembers in it, or without. */
    private static boolean isCalled(String name, State state, StateMachine machine) {
        return state.name().equals(name) || machine.withoutMemory(state).name().equals(name);
    }
}
