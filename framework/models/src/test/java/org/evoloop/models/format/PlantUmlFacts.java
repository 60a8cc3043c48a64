package org.evoloop.models.format;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.models.chart.ArcLabel;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;

/** A chart that was read from PlantUML, in the words of {@code oracles/PlantUml.java}. */
final class PlantUmlFacts {
    private final List<String> facts = new ArrayList<>();

    private PlantUmlFacts() {}

    static List<String> of(Statechart chart) {
        PlantUmlFacts lines = new PlantUmlFacts();
        lines.regions(chart.regions(), "-");
        return lines.facts;
    }

    private void regions(List<Region> regions, String parent) {
        for (Region region : regions) {
            region.vertices().forEach(vertex -> vertex(vertex, parent));
            for (Arc arc : region.arcs()) {
                String label = ArcLabel.of(arc);
                facts.add(
                        "edge " + end(arc.source()) + " " + end(arc.target()) + (label.isEmpty() ? "" : " : " + label));
            }
        }
    }

    private void vertex(Vertex vertex, String parent) {
        if (!vertex.key().startsWith("[")) {
            facts.add("state " + vertex.key() + " " + parent);
        }
        if (vertex instanceof ChartState state) {
            state.connections().forEach(point -> vertex(point, state.key()));
            regions(state.regions(), state.key());
        }
    }

    private static String end(String key) {
        return key.startsWith("[") ? key.substring(0, key.indexOf(']') + 1) : key;
    }
}
