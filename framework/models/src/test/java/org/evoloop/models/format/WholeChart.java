package org.evoloop.models.format;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Place;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.FinalState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;

/** A chart with every construct, and names that diagram languages treat specially. */
final class WholeChart {
    static final Statechart CHART = chart();

    private WholeChart() {}

    private static Statechart chart() {
        List<Vertex> vertices = new ArrayList<>();
        List<Arc> arcs = new ArrayList<>();
        for (Kind kind : Kind.values()) {
            String key = kind.name().toLowerCase(java.util.Locale.ROOT);
            vertices.add(new Pseudostate(key, "the " + key + " <one>", Place.NONE, kind));
            arcs.add(arc(key, "outer", "", "from " + key, "does \"" + key + "\"", Arc.Kind.EXTERNAL));
        }
        vertices.add(new FinalState("final", "the \"very\" end", Place.NONE));
        Region left = region("left side", ChartState.simple("a", "same", Place.NONE));
        Region right =
                region("right side", ChartState.simple("b", "«device <up> & stop» «sends speed» same", Place.NONE));
        vertices.add(new ChartState(
                "outer",
                "Outer & co",
                Place.NONE,
                List.of("switch(\"on\")"),
                List.of("switch(\"off\")"),
                List.of("hum {quietly}"),
                List.of(arc("outer", "outer", "«urgent» tick", "x < 1", "count\nagain", Arc.Kind.INTERNAL)),
                List.of("later"),
                List.of(left, right),
                List.of(
                        new Pseudostate("in", "way in", Place.NONE, Kind.ENTRY_POINT),
                        new Pseudostate("out", "way out", Place.NONE, Kind.EXIT_POINT))));
        arcs.add(arc("outer", "final", "stop; now", "[ready]", "say 'bye' / leave", Arc.Kind.EXTERNAL));
        arcs.add(arc("outer", "a", "«spontaneous, urgent» again", "", "", Arc.Kind.LOCAL));
        return new Statechart(
                "the whole", Place.NONE, List.of(new Region("", Place.NONE, vertices, arcs)), List.of("declared only"));
    }

    private static Region region(String name, ChartState... states) {
        List<Vertex> vertices = new ArrayList<>(List.of(states));
        String initial = name + " start";
        vertices.add(new Pseudostate(initial, "", Place.NONE, Kind.INITIAL));
        Arc first = arc(initial, states[0].key(), "", "", "begin " + name, Arc.Kind.EXTERNAL);
        return new Region(name, Place.NONE, vertices, List.of(first));
    }

    private static Arc arc(String source, String target, String trigger, String guard, String effect, Arc.Kind kind) {
        return new Arc(
                Place.NONE,
                source,
                target,
                trigger.isEmpty() ? List.of() : List.of(trigger),
                guard,
                effect.isEmpty() ? List.of() : List.of(effect),
                kind);
    }
}
