package org.evoloop.evolution;

import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * Where an evolved device stands: the current states of both models (the paper's oState and nState).
 *
 * <p>Threading: immutable.
 *
 * @param original where the device is
 * @param evolved where the evolved system is
 */
public record Configuration(State original, State evolved) {

    // By hand, see State.

    @Override
    public boolean equals(@Nullable Object other) {
        return this == other
                || (other instanceof Configuration configuration
                        && original.equals(configuration.original)
                        && evolved.equals(configuration.evolved));
    }

    /** Tells configurations apart whose two states have the same name, as most have. */
    @Override
    public int hashCode() {
        return 30 * original.hashCode() + evolved.hashCode();
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
