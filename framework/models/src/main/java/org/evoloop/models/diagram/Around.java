package org.evoloop.models.diagram;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.evoloop.models.diagram.Diagram.Edge;
import org.evoloop.models.diagram.Diagram.Node;

/**
 * A state of a diagram with all ways out of it, those of the states around it included, and with those states as its
 * frame. Other ways in are left out.
 */
public final class Around {
    private final Set<String> leaving = new HashSet<>();
    private final Set<String> kept = new HashSet<>();

    private Around() {}

    /**
     * The part around a state.
     *
     * @param key of the state
     */
    public static Diagram of(Diagram diagram, String key) {
        Around part = new Around();
        diagram.nodes().forEach(node -> part.collectFrames(node, key));
        List<Edge> edges = diagram.edges().stream()
                .filter(edge -> part.leaving.contains(edge.source()))
                .toList();
        part.kept.addAll(part.leaving);
        edges.forEach(edge -> part.kept.add(edge.target()));
        List<Node> nodes = new ArrayList<>();
        diagram.nodes().forEach(node -> part.keep(node, nodes));
        return new Diagram(diagram.title(), nodes, Overview.joined(edges));
    }

    /** Whether the state is here; then this is left when the state is. */
    private boolean collectFrames(Node node, String key) {
        boolean around = node.key().equals(key);
        for (Node child : node.children()) {
            around |= collectFrames(child, key);
        }
        if (around) {
            leaving.add(node.key());
        }
        return around;
    }

    private void keep(Node node, List<Node> into) {
        List<Node> inside = new ArrayList<>();
        node.children().forEach(child -> keep(child, inside));
        if (kept.contains(node.key()) || !inside.isEmpty()) {
            into.add(node.with(inside));
        }
    }
}
