package org.evoloop.evolution;

import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Names;

/**
 * The events that a converter of two models can hear of; all others are unknown to it.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class EventNames {
    private final Map<String, Event> known = new HashMap<>();

    /** Those of {@code events}. */
    public EventNames(Set<Event> events) {
        events.forEach(this::add);
    }

    /** Those of both models. */
    public static EventNames of(ModelPair pair) {
        EventNames names = new EventNames(pair.evolved().events());
        pair.original().events().forEach(names::add);
        return names;
    }

    private void add(Event event) {
        known.put(event.name(), event.trigger());
    }

    /** The event of this name, the same object each time if it is known: a new one would be garbage in every event. */
    public Event named(String name) {
        Event event = known.get(name);
        return event == null ? new Event(name) : event;
    }

    /** Whether {@code event} is one of them, whatever its guards. */
    public boolean knows(Event event) {
        return known.containsKey(event.name());
    }

    /** For messages, of an event that is not known. */
    public String unknown(Event event) {
        return "unknown event " + Names.shown(event.name()) + Names.hint(event.name(), known.keySet());
    }

    /** Refuses an event that is not known. @throws IllegalArgumentException if neither model knows {@code event}; the message tells the nearest names */
    public void require(Event event) {
        if (!knows(event)) {
            throw new IllegalArgumentException(unknown(event));
        }
    }
}
