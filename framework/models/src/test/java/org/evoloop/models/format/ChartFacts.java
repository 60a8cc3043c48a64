package org.evoloop.models.format;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.models.chart.ChartIndex;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;

/** All texts in a chart. */
final class ChartFacts {
    /** What every format shows. */
    final List<String> drawn = new ArrayList<>();
    /** What pictures leave out: events that are on no transition. */
    final List<String> declared;
    /** Names of parallel regions. */
    final List<String> regions = new ArrayList<>();

    ChartFacts(Statechart chart) {
        ChartIndex index = new ChartIndex(chart);
        declared = index.events();
        drawn.add(chart.name());
        regions(chart.regions());
        for (Vertex vertex : index.vertices()) {
            if (!ChartIndex.isInitial(vertex)) {
                drawn.add(vertex.name());
            }
            if (vertex instanceof ChartState state) {
                regions(state.regions());
                drawn.addAll(state.entry());
                drawn.addAll(state.doActivities());
                drawn.addAll(state.exit());
                drawn.addAll(state.deferred());
                drawn.add(state.use().device());
                drawn.addAll(state.use().sends());
            }
        }
        for (Arc arc : index.arcs()) {
            drawn.addAll(arc.triggers());
            drawn.add(arc.guard());
            drawn.addAll(arc.effects());
        }
    }

    private void regions(List<Region> some) {
        if (some.size() > 1) {
            some.forEach(region -> regions.add(region.name()));
        }
    }
}
