package org.evoloop.homeassistant;

import java.util.Set;
import org.evoloop.payload.JsonRecord;

/**
 * An entity as Home Assistant knows it.
 *
 * <p>Threading: immutable.
 */
record Entity(String id, String state, JsonRecord attributes) {
    /** Their state is the time at which something happened last, if anything has. */
    private static final Set<String> OF_EVENTS = Set.of("event", "button", "input_button", "scene");

    static String domain(String id) {
        return id.substring(0, id.indexOf('.'));
    }

    /** Whether each change of its state is an event. */
    boolean isOfEvents() {
        return OF_EVENTS.contains(domain(id));
    }

    /** Whether it can be reached. */
    boolean isHere() {
        return !state.equals("unavailable") && (!state.equals("unknown") || isOfEvents());
    }
}
