package org.evoloop.models.diagram;

import java.util.List;

/**
 * What to draw of one state machine, before layout.
 *
 * <p>Threading: immutable.
 *
 * @param title the heading above it; empty for none
 * @param edges between nodes at any depth
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
     * @param name shown inside states, below other shapes, and not at initial pseudostates
     * @param notes the lines of a state's second compartment: behaviors and internal transitions
     * @param children the nodes inside; for an orthogonal state its regions
     */
    public record Node(String key, Shape shape, String name, List<String> notes, List<Node> children, Tone tone) {
        public Node {
            notes = List.copyOf(notes);
            children = List.copyOf(children);
        }

        /** A node without children. */
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

    /** What an element's colour says about it. */
    public enum Tone {
        /** Nothing special. */
        PLAIN,
        /** Added by the new model. */
        ADDED,
        /** Has another target or other effects in the new model. */
        REROUTED,
        /** The former target of a rerouted transition. */
        FORMER,
        /** Removed by the new model. */
        REMOVED,
        /** Part of a counterexample. */
        MARKED,
        /** During a swap of models, events are sent to keep this state. */
        SENDING,
        /** A swap of models waits until this state is left. */
        WAITING,
        /** A swap of models is impossible in this state. */
        STUCK,
        /** Other models decided an event differently in this state. */
        OTHERWISE,
        /** A property was broken in this state. */
        BROKEN
    }
}
