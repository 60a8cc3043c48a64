package org.evoloop.learn;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * All that was ever answered. A node is reached from the reset by the inputs on the way to it; an input that leaves the device
 * alone leads back to its node.
 */
final class AnswerTree {
    private final Node root = new Node(null, "", "");

    /** Where the device is after the inputs on the way here. */
    static final class Node {
        private final @Nullable Node before;
        private final String input;
        private final Map<String, Edge> edges = new LinkedHashMap<>();
        private String shown;

        Node(@Nullable Node before, String input, String shown) {
            this.before = before;
            this.input = input;
            this.shown = shown;
        }

        @Nullable
        Edge edge(String next) {
            return edges.get(next);
        }

        Map<String, Edge> edges() {
            return edges;
        }

        /** What the device shows here. */
        String shown() {
            return shown;
        }

        /** The inputs from the reset to here. */
        List<String> path() {
            Deque<String> path = new ArrayDeque<>();
            for (Node node = this; node.before != null; node = node.before) {
                path.addFirst(node.input);
            }
            return new ArrayList<>(path);
        }
    }

    /** An answer. */
    static final class Edge {
        private final Heard heard;
        private final Node target;
        private int seen;
        private Duration soonest;
        private Duration latest;

        private Edge(Heard heard, Node target) {
            this.heard = heard;
            this.target = target;
            this.soonest = heard.after();
            this.latest = heard.after();
        }

        Heard heard() {
            return heard;
        }

        Node target() {
            return target;
        }

        /** How often it was heard. */
        int seen() {
            return seen;
        }

        Duration soonest() {
            return soonest;
        }

        Duration latest() {
            return latest;
        }

        private void again(Heard now) {
            seen++;
            soonest = soonest.compareTo(now.after()) < 0 ? soonest : now.after();
            latest = latest.compareTo(now.after()) > 0 ? latest : now.after();
        }
    }

    /** An answer that differs from the one in the tree. */
    record Contradiction(Node at, Step step) {}

    Node root() {
        return root;
    }

    void rootShows(String shown) {
        root.shown = shown;
    }

    /** Adds what was heard, up to the first contradiction, which is returned; null if there is none. */
    @Nullable
    Contradiction add(List<Step> steps) {
        Node node = root;
        for (Step step : steps) {
            Edge edge = node.edges.get(step.input());
            if (edge == null) {
                Node target = step.heard().leavesItAlone()
                        ? node
                        : new Node(node, step.input(), step.heard().shown());
                edge = new Edge(step.heard(), target);
                node.edges.put(step.input(), edge);
            } else if (!edge.heard.output().equals(step.heard().output())) {
                return new Contradiction(node, step);
            }
            edge.again(step.heard());
            node = edge.target;
        }
        return null;
    }

    /** The node behind {@code inputs}; null if that is not known. */
    @Nullable
    Node at(List<String> inputs) {
        Node node = root;
        for (String input : inputs) {
            Edge edge = node.edges.get(input);
            if (edge == null) {
                return null;
            }
            node = edge.target;
        }
        return node;
    }

    /** Forgets the answer to {@code input}, and all behind it. */
    static void cut(Node node, String input) {
        node.edges.remove(input);
    }
}
