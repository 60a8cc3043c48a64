package org.evoloop.evolution;

import org.evoloop.statemachine.Event;

/**
 * An event that can come in a configuration, and the decision on it.
 *
 * <p>Threading: immutable.
 *
 * @param event the event, with the guards under which it comes
 * @param deviceActed whether the device acted on it before anything was decided, although it could have been sent
 * @since 0.1
 */
public record Turn(Event event, boolean deviceActed, Decision decision) {

    /** Whether the function of the new model's state sends the event; the new model stays where it is. */
    public boolean isSent() {
        return decision instanceof Decision.Sending;
    }

    /** For messages: {@code Clean (the device acted)}. */
    @Override
    public String toString() {
        return event + (deviceActed ? " (the device acted)" : isSent() ? " (sent by the function)" : "");
    }
}
