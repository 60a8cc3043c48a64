package org.evoloop.evolution;

import static java.util.Objects.requireNonNull;

import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * The current states of both models of an evolved device (the paper's oState and nState).
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class Configuration {
    private final State original;
    private final State evolved;
    /**
     * Cached, like that of a {@link State}, and different for configurations whose two states have the same name, as
     * most have.
     */
    private final int hash;

    /**
     * @param original the device's state
     * @param evolved the evolved system's state
     * @throws NullPointerException if one of them is null; the message says which
     */
    public Configuration(State original, State evolved) {
        this.original = requireNonNull(original, "the device's state is null");
        this.evolved = requireNonNull(evolved, "the evolved system's state is null");
        this.hash = 30 * original.hashCode() + evolved.hashCode();
    }

    /** The device's state. */
    public State original() {
        return original;
    }

    /** The evolved system's state. */
    public State evolved() {
        return evolved;
    }

    @Override
    public boolean equals(@Nullable Object other) {
        return this == other
                || (other instanceof Configuration configuration
                        && hash == configuration.hash
                        && original.equals(configuration.original)
                        && evolved.equals(configuration.evolved));
    }

    @Override
    public int hashCode() {
        return hash;
    }

    /** A copy with the device in {@code state}. */
    public Configuration withOriginal(State state) {
        return new Configuration(state, evolved);
    }

    /** A copy with the evolved system in {@code state}. */
    public Configuration withEvolved(State state) {
        return new Configuration(original, state);
    }

    /** For messages: {@code (Clean, SpotWait)}. */
    @Override
    public String toString() {
        return "(" + original + ", " + evolved + ")";
    }
}
