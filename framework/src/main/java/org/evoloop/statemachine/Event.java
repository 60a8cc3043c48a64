package org.evoloop.statemachine;

import java.time.Duration;
import java.util.Optional;

/**
 * An event that may trigger transitions; its identity is its name, as drawn on the transition.
 *
 * <p>Threading: immutable.
 *
 * @param name as drawn, not blank; a name such as {@code tm(2s)} is a time trigger
 */
public record Event(String name) implements Comparable<Event> {

    /** @throws ModelException if {@code name} is blank */
    public Event {
        if (name.isBlank()) {
            throw new ModelException("an event has no name; give it one");
        }
    }

    /**
     * How long a state must last before this event is raised by itself; empty for an event that somebody must raise.
     *
     * @throws ModelException if the name has the form of a time trigger but holds no duration, see {@link TimeTrigger}
     */
    public Optional<Duration> timeTrigger() {
        return TimeTrigger.parse(name);
    }

    /** Orders by name. */
    @Override
    public int compareTo(Event other) {
        return name.compareTo(other.name);
    }

    @Override
    public String toString() {
        return name;
    }
}
