package org.evoloop.statechart;

import java.util.List;

/**
 * A node of a statechart. {@link Arc Arcs} refer to it by its key.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface Vertex {
    /** Unique in its statechart and not empty; the element's id in the file if it has one. */
    String key();

    /** As drawn; may be empty except for a state. */
    String name();

    /** Its place in the file. */
    Place place();

    /**
     * A state: simple without regions, composite with one, orthogonal with several. A submachine state contains a copy
     * of its machine, with separate keys.
     *
     * @param entry behaviors on entering, in order
     * @param exit behaviors on leaving, in order
     * @param doActivities behaviors that run while it is active
     * @param internal transitions that neither leave nor enter it
     * @param deferred triggers that are deferred while it is active
     * @param connections its entry and exit points
     * @param use what it has to do with the device
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
            List<Pseudostate> connections,
            DeviceUse use)
            implements Vertex {
        public ChartState {
            entry = List.copyOf(entry);
            exit = List.copyOf(exit);
            doActivities = List.copyOf(doActivities);
            internal = List.copyOf(internal);
            deferred = EventKeywords.unmarked(deferred);
            regions = List.copyOf(regions);
            connections = List.copyOf(connections);
        }

        /** @param drawn the name, with the keywords of {@link DeviceUse} if there are any */
        public ChartState(
                String key,
                String drawn,
                Place place,
                List<String> entry,
                List<String> exit,
                List<String> doActivities,
                List<Arc> internal,
                List<String> deferred,
                List<Region> regions,
                List<Pseudostate> connections) {
            this(
                    key,
                    DeviceUse.unmarked(drawn),
                    place,
                    entry,
                    exit,
                    doActivities,
                    internal,
                    deferred,
                    regions,
                    connections,
                    DeviceUse.of(drawn));
        }

        /** The same state with another {@link #use}. */
        public ChartState with(DeviceUse other) {
            return new ChartState(
                    key, name, place, entry, exit, doActivities, internal, deferred, regions, connections, other);
        }

        /** A state without contents. */
        public static ChartState simple(String key, String name, Place place) {
            return new ChartState(
                    key, name, place, List.of(), List.of(), List.of(), List.of(), List.of(), List.of(), List.of());
        }
    }

    /** A vertex that transitions pass through; {@link Kind#TERMINATE} ends the machine. */
    record Pseudostate(String key, String name, Place place, Kind kind) implements Vertex {}

    /**
     * The end of a region.
     *
     * @param entry behaviors on entering, in order; only SCXML has them
     * @param exit behaviors on leaving, in order; only SCXML has them
     */
    record FinalState(String key, String name, Place place, List<String> entry, List<String> exit) implements Vertex {
        public FinalState {
            entry = List.copyOf(entry);
            exit = List.copyOf(exit);
        }

        /** A final state without behaviors. */
        public FinalState(String key, String name, Place place) {
            this(key, name, place, List.of(), List.of());
        }
    }

    /** The kinds of pseudostate of UML 2. */
    enum Kind {
        /** The start of a region. */
        INITIAL,
        /** Enters the substate that was active last. */
        SHALLOW_HISTORY,
        /** Enters the substates that were active last, at every depth. */
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
