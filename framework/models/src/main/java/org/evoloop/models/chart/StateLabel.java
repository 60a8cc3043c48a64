package org.evoloop.models.chart;

import java.util.List;
import java.util.stream.Stream;
import org.evoloop.statechart.Vertex.ChartState;

/** The text inside a state, in UML's notation. */
public final class StateLabel {
    private StateLabel() {}

    /** The lines below the state's name. */
    public static List<String> belowName(ChartState state) {
        return Stream.of(
                        state.entry().stream().map(behavior -> "entry / " + behavior),
                        state.doActivities().stream().map(behavior -> "do / " + behavior),
                        state.exit().stream().map(behavior -> "exit / " + behavior),
                        state.internal().stream().map(ArcLabel::of),
                        state.deferred().stream().map(event -> event + " / defer"))
                .flatMap(lines -> lines)
                .toList();
    }
}
