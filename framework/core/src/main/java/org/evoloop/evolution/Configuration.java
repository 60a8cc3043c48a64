package org.evoloop.evolution;

import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * Where an evolved device stands: the current states of both models (the paper's oState and nState).
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class Configuration {
    private final State original;
    private final State evolved;
    /** Kept, as that of a {@link State}. It tells apart those whose two states have the same name, as most have. */
    private final int hash;

    /**
     * @param original where the device is
     * @param evolved where the evolved system is
     */
    public Configuration(State original, State evolved) {
        this.original = original;
        this.evolved = evolved;
        this.hash = 30 * original.hashCode() + evolved.hashCode();
    }

    /** Where the device is. */
    public State original() {
        return original;
    }

    /** Where the evolved system is. */
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

    /** The same with the device moved to {@code state}. */
    public Configuration withOriginal(State state) {
        return new Configuration(state, evolved);
    }

    /** The same with the evolved system moved to {@code state}. */
    public Configuration withEvolved(State state) {
        return new Configuration(original, state);
    }

    /** For messages: {@code (Clean, SpotWait)}. */
    @Override
    public String toString() {
        return "(" + original + ", " + evolved + ")";
    }
}
