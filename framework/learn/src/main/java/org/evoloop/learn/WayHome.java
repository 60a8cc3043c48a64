package org.evoloop.learn;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/**
 * How a device is brought to where every word begins.
 *
 * <p>Threading: immutable.
 *
 * @param home the state that it shows there; empty if it does not say where it is
 * @param events what is sent until it is there; once, if it does not say where it is
 * @param eventsIn what is sent besides in some states until it is there
 * @param within how long it may take to arrive once that was sent
 * @since 0.1
 */
public record WayHome(String home, List<String> events, Map<String, List<String>> eventsIn, Duration within) {
    public WayHome {
        events = List.copyOf(events);
        eventsIn = Map.copyOf(eventsIn);
    }

    /** What is sent in a state. */
    List<String> from(String shown) {
        List<String> all = new ArrayList<>(eventsIn.getOrDefault(shown, List.of()));
        all.addAll(events);
        return all;
    }

    /** For messages: all that may be sent. */
    @Override
    public String toString() {
        Set<String> all = new TreeSet<>(events);
        eventsIn.values().forEach(all::addAll);
        return all.isEmpty() ? "itself" : String.join(", ", all);
    }
}
