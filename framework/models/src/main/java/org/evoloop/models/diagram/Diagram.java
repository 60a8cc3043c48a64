package org.evoloop.models.diagram;

import java.util.List;

/**
 * What is to be drawn of one state machine, before anybody knows where.
 *
 * <p>Threading: immutable.
 *
 * @param title stands above it; empty for none
 * @param edges between nodes of any depth
 */
public record Diagram(String title, List<Node> nodes, List<Edge> edges) {
    public Diagram {
        nodes = List.copyOf(nodes);
        edges = List.copyOf(edges);
    }

    /**
     * A node.
     *
     * @param key unique in the diagram
     * @param name drawn in a state and under anything else but an initial pseudostate
     * @param notes the lines of a state's second compartment: behaviors and internal transitions
     * @param children nodes inside; for an orthogonal state its regions
     */
    public record Node(String key, Shape shape, String name, List<String> notes, List<Node> children, Tone tone) {
        public Node {
            notes = List.copyOf(notes);
            children = List.copyOf(children);
        }

        /** A node without anything inside. */
        public static Node of(String key, Shape shape, String name, Tone tone) {
            return new Node(key, shape, name, List.of(), List.of(), tone);
        }
    }

    /**
     * An arrow.
     *
     * @param source key of a node
     * @param target key of a node
     * @param label may be empty
     */
    public record Edge(String source, String target, String label, Tone tone) {}

    /** UML's notation for a node. */
    public enum Shape {
        STATE,
        REGION,
        INITIAL,
        FINAL,
        CHOICE,
        JUNCTION,
        BAR,
        SHALLOW_HISTORY,
        DEEP_HISTORY,
        ENTRY_POINT,
        EXIT_POINT,
        TERMINATE
    }

    /** What a part says besides being there. */
    public enum Tone {
        /** Nothing more. */
        PLAIN,
        /** The new model adds it. */
        ADDED,
        /** The new model leads it elsewhere, or has it do something else. */
        REROUTED,
        /** Where the original model led what is rerouted. */
        FORMER,
        /** The new model lacks it. */
        REMOVED,
        /** Part of a counter-example. */
        MARKED,
        /** In a swap of models events are sent to keep it. */
        SENDING,
        /** A swap of models waits until it is left. */
        WAITING,
        /** No swap of models is possible in it. */
        STUCK,
        /** Other models decide otherwise what happened in it. */
        OTHERWISE,
        /** A property is broken in it. */
        BROKEN
    }
}
