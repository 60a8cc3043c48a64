package org.evoloop.statechart;

import java.util.List;

/**
 * A node of a statechart, with an identity of its own that {@link Arc arcs} refer to.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface Vertex {
    /** Unique in its statechart, not empty; the id in the file where that has one. */
    String key();

    /** As drawn; may be empty for anything but a state. */
    String name();

    /** Where it is drawn. */
    Place place();

    /**
     * A state: simple without regions, composite with one, orthogonal with several. The machine of a submachine state
     * is expanded in its place, with keys of its own.
     *
     * @param entry behaviors on entering, in order
     * @param exit behaviors on leaving, in order
     * @param doActivities behaviors that run while it lasts
     * @param internal transitions that neither leave nor enter it
     * @param deferred triggers that wait while it lasts
     * @param connections its entry and exit points
     */
    record ChartState(
            String key,
            String name,
            Place place,
            List<String> entry,
            List<String> exit,
            List<String> doActivities,
            List<Arc> internal,
            List<String> deferred,
            List<Region> regions,
            List<Pseudostate> connections)
            implements Vertex {
        public ChartState {
            entry = List.copyOf(entry);
            exit = List.copyOf(exit);
            doActivities = List.copyOf(doActivities);
            internal = List.copyOf(internal);
            deferred = Spontaneous.unmarked(deferred);
            regions = List.copyOf(regions);
            connections = List.copyOf(connections);
        }

        /** A state without contents. */
        public static ChartState simple(String key, String name, Place place) {
            return new ChartState(
                    key, name, place, List.of(), List.of(), List.of(), List.of(), List.of(), List.of(), List.of());
        }
    }

    /** A vertex in which the machine never rests. */
    record Pseudostate(String key, String name, Place place, Kind kind) implements Vertex {}

    /** The end of a region. */
    record FinalState(String key, String name, Place place) implements Vertex {}

    /** The kinds of pseudostate of UML 2. */
    enum Kind {
        /** Where a region begins. */
        INITIAL,
        /** The substate that its state was in last. */
        SHALLOW_HISTORY,
        /** The substates, at every depth, that its state was in last. */
        DEEP_HISTORY,
        /** Waits for all regions that lead to it. */
        JOIN,
        /** Enters several regions at once. */
        FORK,
        /** Joins and splits transitions; guards are evaluated before any of them is taken. */
        JUNCTION,
        /** Splits a transition; guards are evaluated when it is reached. */
        CHOICE,
        /** A way into a state or a submachine. */
        ENTRY_POINT,
        /** A way out of a state or a submachine. */
        EXIT_POINT,
        /** Ends the machine. */
        TERMINATE
    }
}
