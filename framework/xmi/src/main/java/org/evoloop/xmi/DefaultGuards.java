package org.evoloop.xmi;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.xmi.dialect.Problems;

/** Finds guards that are never evaluated, because their transitions are always taken. */
final class DefaultGuards {
    private static final Set<Vertex.Kind> DEFAULTS =
            Set.of(Vertex.Kind.INITIAL, Vertex.Kind.SHALLOW_HISTORY, Vertex.Kind.DEEP_HISTORY);

    private DefaultGuards() {}

    static void note(Statechart chart, Problems problems) {
        note(chart.regions(), new HashSet<>(), problems);
    }

    private static void note(List<Region> regions, Set<String> defaults, Problems problems) {
        for (Region region : regions) {
            for (Vertex vertex : region.vertices()) {
                if (vertex instanceof Vertex.Pseudostate pseudostate && DEFAULTS.contains(pseudostate.kind())) {
                    defaults.add(vertex.key());
                } else if (vertex instanceof Vertex.ChartState state) {
                    note(state.regions(), defaults, problems);
                }
            }
        }
        regions.forEach(region -> region.arcs().forEach(arc -> note(arc, defaults, problems)));
    }

    private static void note(Arc arc, Set<String> defaults, Problems problems) {
        if (defaults.contains(arc.source()) && !arc.guard().isEmpty()) {
            problems.note(
                    arc.place(),
                    "the guard [" + arc.guard()
                            + "] of a transition from an initial pseudostate or history is not evaluated, since "
                            + "nothing else could be entered; draw a choice behind it if there is something else");
        }
    }
}
