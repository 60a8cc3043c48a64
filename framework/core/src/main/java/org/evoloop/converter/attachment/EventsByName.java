package org.evoloop.converter.attachment;

import java.util.LinkedHashSet;
import java.util.Set;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.jspecify.annotations.Nullable;

/** The events that a component names. */
public final class EventsByName {
    private EventsByName() {}

    /**
     * The events of these names.
     *
     * @param who the method that returned {@code names}, for messages
     * @throws ModelException if {@code names} is null or contains a blank name
     */
    public static Set<Event> of(String who, @Nullable Set<String> names) {
        if (names == null) {
            throw new ModelException(who + " is null; return Set.of() if there are none");
        }
        Set<Event> events = new LinkedHashSet<>();
        for (String name : names) {
            if (name == null || name.isBlank()) {
                throw new ModelException(who + " holds an event without a name");
            }
            events.add(new Event(name));
        }
        return events;
    }
}
