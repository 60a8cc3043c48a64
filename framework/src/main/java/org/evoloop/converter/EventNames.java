package org.evoloop.converter;

import java.util.HashSet;
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
    private final Set<String> known = new HashSet<>();

    EventNames(Set<Event> events) {
        events.forEach(event -> known.add(event.name()));
    }

    static EventNames of(ModelPair pair) {
        EventNames names = new EventNames(pair.evolved().events());
        pair.original().events().forEach(event -> names.known.add(event.name()));
        return names;
    }

    boolean knows(Event event) {
        return known.contains(event.name());
    }

    /** For messages, of an event that is not known. */
    String unknown(Event event) {
        return "unknown event " + event.name() + Names.hint(event.name(), known);
    }

    /** @throws IllegalArgumentException if neither model knows {@code event}; the message tells the nearest names */
    void require(Event event) {
        if (!knows(event)) {
            throw new IllegalArgumentException(unknown(event));
        }
    }
}
