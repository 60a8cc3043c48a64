package org.evoloop.models.chart;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.FinalState;

/** The text inside a state, in UML's notation. */
public final class StateLabel {
    private StateLabel() {}

    /** The text beside a vertex that is not a state: its name, and what a final state does. */
    public static String beside(Vertex vertex) {
        if (!(vertex instanceof FinalState end)) {
            return vertex.name();
        }
        return Stream.of(
                        Stream.of(end.name()),
                        end.entry().stream().map(behavior -> "entry / " + behavior),
                        end.exit().stream().map(behavior -> "exit / " + behavior))
                .flatMap(parts -> parts)
                .filter(part -> !part.isEmpty())
                .collect(Collectors.joining(" "));
    }

    /** The lines below the state's name. */
    public static List<String> belowName(ChartState state) {
        return Stream.of(
                        Stream.of(state.use().keywords()).filter(keywords -> !keywords.isEmpty()),
                        state.entry().stream().map(behavior -> "entry / " + behavior),
                        state.doActivities().stream().map(behavior -> "do / " + behavior),
                        state.exit().stream().map(behavior -> "exit / " + behavior),
                        state.internal().stream().map(ArcLabel::of),
                        state.deferred().stream().map(event -> event + " / defer"))
                .flatMap(lines -> lines)
                .toList();
    }
}
