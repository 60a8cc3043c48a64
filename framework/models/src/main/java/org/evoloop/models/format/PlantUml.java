package org.evoloop.models.format;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
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
import org.evoloop.statemachine.Names;

/**
 * Machines in PlantUML's language, one diagram each. PlantUML draws no transition into or out of a concurrent region but
 * the first of its state. Such a transition is drawn from or to that state, and its label says where it really begins or
 * ends.
 */
public final class PlantUml {
    private final ChartIndex index;
    private final PlantUmlRegions regions;
    private final Map<String, String> aliases = new HashMap<>();
    private final StringBuilder text = new StringBuilder();

    private PlantUml(Statechart chart) {
        this.index = new ChartIndex(chart);
        this.regions = new PlantUmlRegions(chart);
        index.vertices().forEach(vertex -> aliases.put(vertex.key(), "v" + aliases.size()));
    }

    /** The text for {@code charts}. */
    public static String write(List<Statechart> charts) {
        return charts.stream().map(PlantUml::of).collect(Collectors.joining("\n"));
    }

    private static String of(Statechart chart) {
        PlantUml writer = new PlantUml(chart);
        writer.line(0, "@startuml");
        writer.line(0, "hide empty description");
        writer.line(0, "title " + oneLine(chart.name()));
        writer.regions(chart.regions(), 0);
        writer.regions.acrossAll().forEach(arc -> writer.arc(arc, 0));
        writer.line(0, "@enduml");
        return writer.text.toString();
    }

    private void regions(List<Region> all, int depth) {
        for (int i = 0; i < all.size(); i++) {
            if (i > 0) {
                line(depth, "--");
            }
            all.get(i).vertices().forEach(vertex -> vertex(vertex, depth));
            regions.writtenIn(all.get(i)).forEach(arc -> arc(arc, depth));
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

    private void arc(PlantUmlRegions.Drawn drawn, int depth) {
        Arc arc = drawn.arc();
        String ends = Stream.of(
                        drawn.source().equals(arc.source()) ? "" : "from " + index.name(arc.source()),
                        drawn.target().equals(arc.target()) ? "" : "to " + index.name(arc.target()))
                .filter(end -> !end.isEmpty())
                .collect(Collectors.joining(" "));
        String label = Stream.of(ArcLabel.of(arc), ends.isEmpty() ? "" : "(" + ends + ")")
                .filter(part -> !part.isEmpty())
                .collect(Collectors.joining(" "));
        line(
                depth,
                aliases.get(drawn.source()) + " --> " + aliases.get(drawn.target())
                        + (label.isEmpty() ? "" : " : " + oneLine(label)));
    }

    private void line(int depth, String content) {
        text.append("  ".repeat(depth)).append(content).append('\n');
    }

    private static String quoted(String name) {
        return oneLine(name).replace("\"", "<U+0022>");
    }

    private static String oneLine(String content) {
        return Names.inOneLine(content.replace("\n", "\\n"));
    }
}
