package org.evoloop.models.diagram;

import java.util.List;
import java.util.Map;

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
     * @param data what a program wants to know of it, by names such as {@code line}; only a plain picture has it
     */
    public record Node(
            String key,
            Shape shape,
            String name,
            List<String> notes,
            List<Node> children,
            Tone tone,
            Map<String, String> data) {
        public Node {
            notes = List.copyOf(notes);
            children = List.copyOf(children);
        }

        /** The same node with other nodes inside. */
        public Node with(List<Node> inside) {
            return new Node(key, shape, name, notes, inside, tone, data);
        }
    }

    /**
     * An arrow.
     *
     * @param source key of a node
     * @param target key of a node
     * @param label may be empty
     * @param data as for a node
     */
    public record Edge(String source, String target, String label, Tone tone, Map<String, String> data) {}

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
