package org.evoloop.models.diagram;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Place;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.FinalState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;

/** Nested charts for layout only: arcs lead from anywhere to anywhere, so they have no meaning. */
public final class RandomChart {
    private static final List<Kind> KINDS = List.of(Kind.values());

    private final Random random;
    private final List<String> keys = new ArrayList<>();
    private int left;

    private RandomChart(long seed) {
        this.random = new Random(seed);
        this.left = 4 + random.nextInt(20);
    }

    public static Statechart of(long seed) {
        RandomChart chart = new RandomChart(seed);
        Region inner = chart.region(0);
        List<Arc> arcs = new ArrayList<>();
        for (int i = 0; i < 4 + chart.random.nextInt(20); i++) {
            String source = chart.keys.get(chart.random.nextInt(chart.keys.size()));
            String target = i % 5 == 0 ? source : chart.keys.get(chart.random.nextInt(chart.keys.size()));
            List<String> effects = i % 3 == 0 ? List.of("effect" + i) : List.of();
            arcs.add(new Arc(
                    Place.NONE,
                    source,
                    target,
                    List.of("event" + i),
                    i % 4 == 0 ? "guard" : "",
                    effects,
                    Arc.Kind.EXTERNAL));
        }
        Region top = new Region("", Place.NONE, inner.vertices(), arcs);
        return new Statechart("random " + seed, Place.NONE, List.of(top), List.of());
    }

    private Region region(int depth) {
        List<Vertex> vertices = new ArrayList<>();
        for (int i = 1 + random.nextInt(4); i >= 0 && (left > 0 || vertices.isEmpty()); i--) {
            left--;
            vertices.add(vertex(depth));
        }
        return new Region("", Place.NONE, vertices, List.of());
    }

    private Vertex vertex(int depth) {
        String key = "v" + keys.size();
        keys.add(key);
        int kind = random.nextInt(8);
        if (kind == 0) {
            return new FinalState(key, "", Place.NONE);
        }
        if (kind == 1) {
            return new Pseudostate(key, "p", Place.NONE, KINDS.get(random.nextInt(KINDS.size())));
        }
        List<Region> regions = new ArrayList<>();
        for (int i = depth < 3 ? Math.max(0, random.nextInt(6) - 3) : 0; i > 0; i--) {
            regions.add(region(depth + 1));
        }
        List<String> entry = random.nextBoolean() ? List.of("switchOn" + key) : List.of();
        return new ChartState(
                key, "State" + key, Place.NONE, entry, List.of(), List.of(), List.of(), List.of(), regions, List.of());
    }
}
