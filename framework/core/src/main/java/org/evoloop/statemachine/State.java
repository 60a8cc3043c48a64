package org.evoloop.statemachine;

import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * A state of a machine; its identity is its name, so that a state of the original model and the state of the same name
 * in the new model are equal (the paper's Condition 2 speaks of names).
 *
 * <p>Threading: immutable.
 *
 * @param name as drawn, not blank
 */
public record State(String name) implements Comparable<State> {

    /** @throws ModelException if {@code name} is blank */
    public State {
        if (Objects.requireNonNull(name, "the name of a state is null").isBlank()) {
            throw new ModelException("a state has no name; give it one");
        }
    }

    // By hand: a record's own go through method handles, which cost some 10 us a call wherever the last of the JVM's
    // compilers has not been, and that one is left out on small computers.

    @Override
    public boolean equals(@Nullable Object other) {
        return this == other || (other instanceof State state && name.equals(state.name));
    }

    @Override
    public int hashCode() {
        return name.hashCode();
    }

    /** Orders by name. */
    @Override
    public int compareTo(State other) {
        return name.compareTo(other.name);
    }

    @Override
    public String toString() {
        return name;
    }
}
