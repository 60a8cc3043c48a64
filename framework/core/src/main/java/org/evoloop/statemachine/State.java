package org.evoloop.statemachine;

import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * A state of a machine; its identity is its name, so that a state of the original model and the state of the same name
 * in the new model are equal (the paper's Condition 2 speaks of names).
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class State implements Comparable<State> {
    private final String name;
    /** Cached, since the states of a large pair are looked up a million times before anything runs. */
    private final int hash;

    /**
     * @param name as drawn, not blank
     * @throws NullPointerException if {@code name} is null
     * @throws ModelException if {@code name} is blank
     */
    public State(String name) {
        if (Objects.requireNonNull(name, "the name of a state is null").isBlank()) {
            throw new ModelException("a state has no name; give it one");
        }
        this.name = name;
        this.hash = name.hashCode();
    }

    /** As drawn, not blank. */
    public String name() {
        return name;
    }

    @Override
    public boolean equals(@Nullable Object other) {
        return this == other || (other instanceof State state && hash == state.hash && name.equals(state.name));
    }

    @Override
    public int hashCode() {
        return hash;
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
