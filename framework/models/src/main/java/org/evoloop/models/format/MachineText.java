package org.evoloop.models.format;

import java.util.List;
import java.util.stream.Collectors;
import org.evoloop.models.chart.ArcLabel;
import org.evoloop.models.chart.ChartIndex;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.FinalState;
import org.evoloop.statemachine.Names;

/** A machine as text: each vertex with its contents and its transitions. */
public final class MachineText {
    private final ChartIndex index;
    private final StringBuilder text = new StringBuilder();

    private MachineText(ChartIndex index) {
        this.index = index;
    }

    /** The text for {@code charts}, separated by blank lines. */
    public static String write(List<Statechart> charts) {
        return charts.stream().map(MachineText::of).collect(Collectors.joining("\n"));
    }

    private static String of(Statechart chart) {
        MachineText writer = new MachineText(new ChartIndex(chart));
        writer.head(chart);
        writer.regions(chart.regions(), 1);
        return writer.text.toString();
    }

    private void head(Statechart chart) {
        long states = index.vertices().stream()
                .filter(vertex -> !(vertex instanceof Vertex.Pseudostate))
                .count();
        text.append(Names.inOneLine(chart.name()))
                .append(": ")
                .append(count(states, "state"))
                .append(", ");
        text.append(count(index.events().size(), "event")).append(", ");
        text.append(count(index.transitions().size(), "transition")).append('\n');
        if (!index.events().isEmpty()) {
            text.append("  events: ")
                    .append(Names.inOneLine(String.join(", ", index.events())))
                    .append('\n');
        }
    }

    private static String count(long number, String what) {
        return number + " " + what + (number == 1 ? "" : "s");
    }

    private void regions(List<Region> regions, int depth) {
        for (Region region : regions) {
            int inner = depth;
            if (regions.size() > 1) {
                line(depth, "region" + (region.name().isEmpty() ? "" : " " + region.name()));
                inner++;
            }
            for (Vertex vertex : region.vertices()) {
                vertex(vertex, inner);
            }
        }
    }

    private void vertex(Vertex vertex, int depth) {
        if (vertex instanceof ChartState state) {
            line(depth, index.name(state.key()));
            if (!state.use().isNone()) {
                line(depth + 1, state.use().keywords());
            }
            state.entry().forEach(behavior -> line(depth + 1, "entry / " + behavior));
            state.doActivities().forEach(behavior -> line(depth + 1, "do / " + behavior));
            state.exit().forEach(behavior -> line(depth + 1, "exit / " + behavior));
            state.deferred().forEach(event -> line(depth + 1, event + " / defer"));
            state.internal().forEach(arc -> line(depth + 1, ArcLabel.of(arc) + " (internal)"));
            leaving(state, depth + 1);
            state.connections().forEach(point -> vertex(point, depth + 1));
            regions(state.regions(), depth + 1);
        } else if (ChartIndex.isInitial(vertex)) {
            leaving(vertex, depth);
        } else {
            line(depth, index.name(vertex.key()) + " (" + ChartIndex.kind(vertex) + ")");
            if (vertex instanceof FinalState end) {
                end.entry().forEach(behavior -> line(depth + 1, "entry / " + behavior));
                end.exit().forEach(behavior -> line(depth + 1, "exit / " + behavior));
            }
            leaving(vertex, depth + 1);
        }
    }

    private void leaving(Vertex vertex, int depth) {
        for (Arc arc : index.leaving(vertex.key())) {
            if (arc.kind() != Arc.Kind.INTERNAL) {
                String label = ArcLabel.of(arc);
                String prefix = ChartIndex.isInitial(vertex) ? "initial " : "";
                line(depth, prefix + (label.isEmpty() ? "" : label + " ") + "-> " + index.name(arc.target()));
            }
        }
    }

    private void line(int depth, String content) {
        text.append("  ".repeat(depth)).append(Names.inOneLine(content)).append('\n');
    }
}
