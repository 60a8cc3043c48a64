package org.evoloop.converter;

import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Names;

/**
 * The events that a converter can hear of.
 *
 * <p>Threading: immutable.
 */
final class EventNames {
    private final Map<String, Event> known = new HashMap<>();

    EventNames(Set<Event> events) {
        events.forEach(this::add);
    }

    static EventNames of(ModelPair pair) {
        EventNames names = new EventNames(pair.evolved().events());
        pair.original().events().forEach(names::add);
        return names;
    }

    private void add(Event event) {
        known.put(event.name(), event.trigger());
    }

    /** The event of this name, the same object each time if it is known: a new one would be garbage in every event. */
    Event named(String name) {
        Event event = known.get(name);
        return event == null ? new Event(name) : event;
    }

    boolean knows(Event event) {
        return known.containsKey(event.name());
    }

    /** For messages, of an event that is not known. */
    String unknown(Event event) {
        return "unknown event " + event.name() + Names.hint(event.name(), known.keySet());
    }

    /** @throws IllegalArgumentException if neither model knows {@code event}; the message tells the nearest names */
    void require(Event event) {
        if (!knows(event)) {
            throw new IllegalArgumentException(unknown(event));
        }
    }
}
