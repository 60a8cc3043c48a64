package org.evoloop.statechart;

import java.util.List;

/**
 * A state machine as drawn, unchecked.
 *
 * <p>Threading: immutable.
 *
 * @param name its name
 * @param place in its file
 * @param regions its top regions, rarely more than one
 * @param events declared in the model; those on transitions need not be included
 * @param semantics the standard that says what it means
 * @since 0.1
 */
public record Statechart(String name, Place place, List<Region> regions, List<String> events, Semantics semantics) {
    public Statechart {
        regions = List.copyOf(regions);
        events = EventKeywords.unmarked(events);
    }

    /** A chart of UML. */
    public Statechart(String name, Place place, List<Region> regions, List<String> events) {
        this(name, place, regions, events, Semantics.UML);
    }

    /** The standards, which differ in what the same drawing does. */
    public enum Semantics {
        /** UML 2.5.1. */
        UML,
        /**
         * SCXML 1.0. The transitions without a trigger are its transitions without an event. The regions of a parallel
         * state have names, all others have none. {@code done.state.KEY} is raised when the state with that key is
         * done.
         */
        SCXML
    }
}
