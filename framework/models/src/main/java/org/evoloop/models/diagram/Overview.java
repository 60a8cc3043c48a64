package org.evoloop.models.diagram;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.models.diagram.Diagram.Edge;
import org.evoloop.models.diagram.Diagram.Node;
import org.evoloop.models.diagram.Diagram.Shape;

/** A diagram with its composite states closed, and with one arrow in place of several between the same two nodes. */
public final class Overview {
    private Overview() {}

    /** The overview of {@code diagram}. */
    public static Diagram of(Diagram diagram) {
        Map<String, String> shown = new HashMap<>();
        List<Node> nodes = new ArrayList<>();
        for (Node node : diagram.nodes()) {
            if (node.shape() == Shape.REGION) {
                List<Node> inside = node.children().stream()
                        .map(each -> closed(each, shown))
                        .toList();
                nodes.add(node.with(inside));
                shown.put(node.key(), node.key());
            } else {
                nodes.add(closed(node, shown));
            }
        }
        List<Edge> edges = diagram.edges().stream()
                .filter(edge -> !isInside(edge, shown))
                .map(edge -> new Edge(
                        shown.getOrDefault(edge.source(), edge.source()),
                        shown.getOrDefault(edge.target(), edge.target()),
                        edge.label(),
                        edge.tone(),
                        edge.data()))
                .toList();
        return new Diagram(diagram.title(), nodes, joined(edges));
    }

    private static Node closed(Node node, Map<String, String> shown) {
        collect(node, node.key(), shown);
        return node.with(List.of());
    }

    private static void collect(Node node, String outer, Map<String, String> shown) {
        shown.put(node.key(), outer);
        node.children().forEach(child -> collect(child, outer, shown));
    }

    /** Whether it can no longer be seen. */
    private static boolean isInside(Edge edge, Map<String, String> shown) {
        String source = shown.getOrDefault(edge.source(), edge.source());
        String target = shown.getOrDefault(edge.target(), edge.target());
        boolean ofOuter = edge.source().equals(source) && edge.target().equals(target);
        return source.equals(target) && !ofOuter;
    }

    /** What joined arrows have in common. */
    private record Way(String source, String target, Diagram.Tone tone) {}

    /** One arrow for those of the same ends and tone, with all labels, and the values of their data with blanks between. */
    static List<Edge> joined(List<Edge> edges) {
        Map<Way, Edge> joined = new LinkedHashMap<>();
        for (Edge edge : edges) {
            joined.merge(new Way(edge.source(), edge.target(), edge.tone()), edge, Overview::both);
        }
        return List.copyOf(joined.values());
    }

    private static Edge both(Edge one, Edge other) {
        String label = one.label().isEmpty() || other.label().isEmpty()
                ? one.label() + other.label()
                : one.label() + ", " + other.label();
        Map<String, String> data = new LinkedHashMap<>(one.data());
        other.data()
                .forEach((key, value) -> data.merge(
                        key,
                        value,
                        (first, next) -> key.equals("source") || key.equals("target") ? first : first + " " + next));
        return new Edge(one.source(), one.target(), label, one.tone(), data);
    }
}
