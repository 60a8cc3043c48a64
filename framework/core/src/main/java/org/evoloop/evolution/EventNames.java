package org.evoloop.evolution;

import static java.util.Objects.requireNonNull;

import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Names;

/**
 * The events that a converter of two models knows; it refuses or ignores all others.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class EventNames {
    private final Map<String, Event> known = new HashMap<>();

    /**
     * The names of {@code events}.
     *
     * @throws NullPointerException if the set is null
     */
    public EventNames(Set<Event> events) {
        requireNonNull(events, "the events are null; Set.of() are none").forEach(this::add);
    }

    /**
     * The events of both models.
     *
     * @throws NullPointerException if {@code pair} is null
     */
    public static EventNames of(ModelPair pair) {
        EventNames names = new EventNames(
                requireNonNull(pair, "the models are null").evolved().events());
        pair.original().events().forEach(names::add);
        return names;
    }

    private void add(Event event) {
        known.put(event.name(), event.trigger());
    }

    /**
     * The event of this name; for a known one always the same object, since a new one would be garbage in every event.
     */
    public Event named(String name) {
        Event event = known.get(name);
        return event == null ? new Event(name) : event;
    }

    /** Whether {@code event} is known, whatever its guards. */
    public boolean knows(Event event) {
        return known.containsKey(event.name());
    }

    /** For messages, of an event that is not known. */
    public String unknown(Event event) {
        return "unknown event " + Names.shown(event.name()) + Names.hint(event.name(), known.keySet());
    }

    /**
     * Refuses an event that is not known.
     *
     * @throws IllegalArgumentException if neither model knows {@code event}; the
     * message lists the most similar names
     */
    public void require(Event event) {
        if (!knows(event)) {
            throw new IllegalArgumentException(unknown(event));
        }
    }
}
