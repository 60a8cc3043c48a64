package org.evoloop.models.format;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.evoloop.models.chart.ArcLabel;
import org.evoloop.models.chart.ChartIndex;
import org.evoloop.models.chart.StateLabel;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.FinalState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;

/** Machines in PlantUML's language, one diagram each. */
public final class PlantUml {
    private final ChartIndex index;
    private final Map<String, String> aliases = new HashMap<>();
    private final StringBuilder text = new StringBuilder();

    private PlantUml(ChartIndex index) {
        this.index = index;
        index.vertices().forEach(vertex -> aliases.put(vertex.key(), "v" + aliases.size()));
    }

    /** The text for {@code charts}. */
    public static String write(List<Statechart> charts) {
        return charts.stream().map(PlantUml::of).collect(Collectors.joining("\n"));
    }

    private static String of(Statechart chart) {
        PlantUml writer = new PlantUml(new ChartIndex(chart));
        writer.line(0, "@startuml");
        writer.line(0, "hide empty description");
        writer.line(0, "title " + oneLine(chart.name()));
        writer.regions(chart.regions(), 0);
        writer.line(0, "@enduml");
        return writer.text.toString();
    }

    /** A transition is written in the region that contains it. */
    private void regions(List<Region> regions, int depth) {
        for (int i = 0; i < regions.size(); i++) {
            if (i > 0) {
                line(depth, "--");
            }
            regions.get(i).vertices().forEach(vertex -> vertex(vertex, depth));
            regions.get(i).arcs().forEach(arc -> arc(arc, depth));
        }
    }

    private void vertex(Vertex vertex, int depth) {
        String alias = aliases.getOrDefault(vertex.key(), "");
        if (vertex instanceof ChartState state) {
            boolean composite =
                    !state.regions().isEmpty() || !state.connections().isEmpty();
            line(depth, "state \"" + quoted(state.name()) + "\" as " + alias + (composite ? " {" : ""));
            if (composite) {
                state.connections().forEach(point -> vertex(point, depth + 1));
                regions(state.regions(), depth + 1);
                line(depth, "}");
            }
            StateLabel.belowName(state).forEach(text -> note(alias, text, depth));
        } else if (vertex instanceof Pseudostate point && point.kind() != Kind.INITIAL) {
            line(
                    depth,
                    "state \"" + quoted(index.name(vertex.key())) + "\" as " + alias + " <<" + stereotype(point.kind())
                            + ">>");
        } else if (vertex instanceof FinalState) {
            String name = StateLabel.beside(vertex);
            line(depth, "state " + (name.isEmpty() ? "" : "\"" + quoted(name) + "\" as ") + alias + " <<end>>");
        } else {
            line(depth, "state " + alias + " <<start>>");
        }
    }

    private static String stereotype(Kind kind) {
        return switch (kind) {
            case INITIAL -> "start";
            case SHALLOW_HISTORY -> "history";
            case DEEP_HISTORY -> "history*";
            case JOIN -> "join";
            case FORK -> "fork";
            // PlantUML has no junction.
            case CHOICE, JUNCTION -> "choice";
            case ENTRY_POINT -> "entryPoint";
            case EXIT_POINT -> "exitPoint";
            case TERMINATE -> "end";
        };
    }

    private void note(String alias, String content, int depth) {
        line(depth, alias + " : " + oneLine(content));
    }

    private void arc(Arc arc, int depth) {
        if (arc.kind() != Arc.Kind.INTERNAL) {
            String label = ArcLabel.of(arc);
            line(
                    depth,
                    aliases.get(arc.source()) + " --> " + aliases.get(arc.target())
                            + (label.isEmpty() ? "" : " : " + oneLine(label)));
        }
    }

    private void line(int depth, String content) {
        text.append("  ".repeat(depth)).append(content).append('\n');
    }

    private static String quoted(String name) {
        return oneLine(name).replace("\"", "<U+0022>");
    }

    private static String oneLine(String content) {
        return content.replace("\n", "\\n");
    }
}
