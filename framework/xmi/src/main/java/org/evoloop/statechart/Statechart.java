package org.evoloop.statechart;

import java.util.List;

/**
 * A UML state machine as drawn, unchecked.
 *
 * <p>Threading: immutable.
 *
 * @param name its name
 * @param place in its file
 * @param regions its top regions, rarely more than one
 * @param events declared in the model; those on transitions need not be included
 * @since 0.1
 */
public record Statechart(String name, Place place, List<Region> regions, List<String> events) {
    public Statechart {
        regions = List.copyOf(regions);
        events = Spontaneous.unmarked(events);
    }
}
