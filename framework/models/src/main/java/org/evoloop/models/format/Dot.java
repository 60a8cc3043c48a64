package org.evoloop.models.format;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.models.chart.ArcLabel;
import org.evoloop.models.chart.ChartIndex;
import org.evoloop.models.chart.StateLabel;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.Pseudostate;

/** Machines in Graphviz's language: one digraph, with a cluster for each machine, composite state and region. */
public final class Dot {
    private final StringBuilder text = new StringBuilder();
    private final Map<String, String> ids = new HashMap<>();
    private int clusters;

    private Dot() {}

    /** The text for {@code charts}. */
    public static String write(List<Statechart> charts) {
        Dot dot = new Dot();
        dot.line(0, "digraph {");
        dot.line(1, "compound=true; rankdir=LR; fontname=\"Helvetica\";");
        dot.line(1, "node [fontname=\"Helvetica\", shape=box, style=rounded];");
        dot.line(1, "edge [fontname=\"Helvetica\", arrowhead=vee];");
        charts.forEach(dot::machine);
        dot.line(0, "}");
        return dot.text.toString();
    }

    private void machine(Statechart chart) {
        // Keys are unique only within a chart.
        ids.clear();
        ChartIndex index = new ChartIndex(chart);
        String prefix = "m" + clusters + "_";
        index.vertices().forEach(vertex -> ids.put(vertex.key(), prefix + "v" + ids.size()));
        cluster(1, chart.name(), "solid");
        chart.regions().forEach(region -> region(region, chart.regions().size() > 1, 2));
        index.arcs().forEach(arc -> edge(arc, index));
        line(1, "}");
    }

    private void cluster(int depth, String label, String style) {
        line(depth, "subgraph cluster_" + clusters++ + " {");
        line(depth + 1, "label=" + quote(label) + "; style=" + style + ";");
    }

    private void region(Region region, boolean framed, int depth) {
        if (framed) {
            cluster(depth, region.name(), "dashed");
        }
        region.vertices().forEach(vertex -> vertex(vertex, framed ? depth + 1 : depth));
        if (framed) {
            line(depth, "}");
        }
    }

    private void vertex(Vertex vertex, int depth) {
        String id = ids.get(vertex.key());
        if (!(vertex instanceof ChartState state)) {
            line(depth, id + " [" + look(vertex) + "];");
        } else if (state.regions().isEmpty() && state.connections().isEmpty()) {
            line(depth, id + " [label=" + quote(compartments(state)) + "];");
        } else {
            cluster(depth, compartments(state), "rounded");
            // An edge must end at a node; this one stands for the whole cluster.
            line(depth + 1, id + " [shape=point, style=invis];");
            state.connections().forEach(point -> vertex(point, depth + 1));
            state.regions().forEach(region -> region(region, state.regions().size() > 1, depth + 1));
            line(depth, "}");
        }
    }

    private static String compartments(ChartState state) {
        String below = String.join("\n", StateLabel.belowName(state));
        return below.isEmpty() ? state.name() : state.name() + "\n" + below;
    }

    private static String look(Vertex vertex) {
        String name = ChartIndex.isInitial(vertex) ? "" : StateLabel.beside(vertex);
        return shape(vertex) + (name.isEmpty() ? "" : ", xlabel=" + quote(name));
    }

    private static String shape(Vertex vertex) {
        if (!(vertex instanceof Pseudostate pseudostate)) {
            return "label=\"\", shape=doublecircle, style=filled, fillcolor=black, width=0.15";
        }
        return switch (pseudostate.kind()) {
            case INITIAL, JUNCTION -> "label=\"\", shape=circle, style=filled, fillcolor=black, width=0.15";
            case CHOICE -> "label=\"\", shape=diamond, style=solid, width=0.3, height=0.3";
            case FORK, JOIN -> "label=\"\", shape=box, style=filled, fillcolor=black, width=0.07, height=0.8";
            case SHALLOW_HISTORY -> "label=\"H\", shape=circle, style=solid, margin=0";
            case DEEP_HISTORY -> "label=\"H*\", shape=circle, style=solid, margin=0";
            case ENTRY_POINT -> "label=\"\", shape=circle, style=solid, width=0.2";
            case EXIT_POINT -> "label=\"x\", shape=circle, style=solid, margin=0, width=0.2";
            case TERMINATE -> "label=\"X\", shape=plaintext, style=solid";
        };
    }

    private void edge(Arc arc, ChartIndex index) {
        if (arc.kind() != Arc.Kind.INTERNAL) {
            index.vertex(arc.target());
            line(
                    2,
                    ids.get(arc.source()) + " -> " + ids.get(arc.target()) + " [label=" + quote(ArcLabel.of(arc))
                            + "];");
        }
    }

    private void line(int depth, String content) {
        text.append("  ".repeat(depth)).append(content).append('\n');
    }

    private static String quote(String raw) {
        return "\"" + raw.replace("\\", "\\\\").replace("\"", "\\\"").replace("\n", "\\n") + "\"";
    }
}
