package org.evoloop.evolution;

import org.evoloop.statemachine.Event;

/**
 * One thing that can happen in a configuration, and what comes of it.
 *
 * <p>Threading: immutable.
 *
 * @param event with the guards under which it comes
 * @param deviceActed whether the device has acted on it before anything was decided, although it could have been asked to
 * @since 0.1
 */
public record Turn(Event event, boolean deviceActed, Decision decision) {

    /** For messages: {@code Clean (the device acted)}. */
    @Override
    public String toString() {
        return event + (deviceActed ? " (the device acted)" : "");
    }
}
