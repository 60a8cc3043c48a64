package org.evoloop.models.diagram;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.models.diagram.Diagram.Edge;
import org.evoloop.models.diagram.Diagram.Node;
import org.evoloop.models.diagram.Diagram.Tone;
import org.evoloop.models.diagram.Layout.Box;
import org.evoloop.models.diagram.Layout.Wire;

/**
 * The layouts of the last diagrams. While a text is edited, most changes are none of its picture, or none of one of its two
 * pictures, and a layout takes most of the time.
 *
 * <p>Threading: thread-safe.
 */
public final class Layouts {
    private static final int MOST = 32;

    /** By the diagrams without tones and data, which need no room. */
    private final Map<Key, Layout> known = new LinkedHashMap<>(MOST, 0.75f, true) {
        private static final long serialVersionUID = 1;

        @Override
        protected boolean removeEldestEntry(Map.Entry<Key, Layout> eldest) {
            return size() > MOST;
        }
    };

    private record Key(Diagram diagram, boolean down) {}

    Layout of(Diagram diagram, boolean down) {
        Key key = new Key(
                new Diagram(
                        "",
                        diagram.nodes().stream().map(Layouts::bare).toList(),
                        diagram.edges().stream()
                                .map(edge -> new Edge(edge.source(), edge.target(), edge.label(), Tone.PLAIN, Map.of()))
                                .toList()),
                down);
        Layout layout;
        synchronized (known) {
            layout = known.get(key);
        }
        if (layout == null) {
            layout = ElkLayout.of(key.diagram(), down);
            synchronized (known) {
                known.put(key, layout);
            }
        }
        return dressed(layout, diagram);
    }

    private static Node bare(Node node) {
        return new Node(
                node.key(),
                node.shape(),
                node.name(),
                node.notes(),
                node.children().stream().map(Layouts::bare).toList(),
                Tone.PLAIN,
                Map.of());
    }

    /** The layout with the nodes and edges of the diagram itself. */
    private static Layout dressed(Layout layout, Diagram diagram) {
        Map<String, Node> nodes = new HashMap<>();
        diagram.nodes().forEach(node -> collect(node, nodes));
        List<Box> boxes = layout.boxes().stream()
                .map(box -> new Box(
                        nodes.getOrDefault(box.node().key(), box.node()), box.x(), box.y(), box.width(), box.height()))
                .toList();
        List<Wire> wires = new ArrayList<>();
        for (int i = 0; i < layout.wires().size(); i++) {
            Wire wire = layout.wires().get(i);
            wires.add(new Wire(diagram.edges().get(i), wire.points(), wire.label(), wire.at()));
        }
        return new Layout(layout.width(), layout.height(), boxes, wires);
    }

    private static void collect(Node node, Map<String, Node> nodes) {
        nodes.put(node.key(), node);
        node.children().forEach(child -> collect(child, nodes));
    }
}
