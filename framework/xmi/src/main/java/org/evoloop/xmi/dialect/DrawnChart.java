package org.evoloop.xmi.dialect;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;
import org.jspecify.annotations.Nullable;

/**
 * A chart whose elements can be looked up, to be written.
 *
 * <p>Threading: immutable.
 */
@SuppressWarnings("ReferenceEquality") // two regions may look alike
public final class DrawnChart {
    private final Statechart chart;
    private final Map<String, Vertex> vertices = new HashMap<>();
    private final Map<String, Region> homes = new HashMap<>();
    private final IdentityHashMap<Region, ChartState> owners = new IdentityHashMap<>();
    private final Map<String, List<Arc>> leaving = new HashMap<>();
    private final List<Arc> arcs = new ArrayList<>();
    private final Set<String> triggers = new LinkedHashSet<>();

    public DrawnChart(Statechart chart) {
        this.chart = chart;
        chart.regions().forEach(this::add);
        for (Arc arc : arcs) {
            leaving.computeIfAbsent(arc.source(), key -> new ArrayList<>()).add(arc);
            triggers.addAll(arc.triggers());
        }
    }

    private void add(Region region) {
        arcs.addAll(region.arcs());
        for (Vertex vertex : region.vertices()) {
            vertices.put(vertex.key(), vertex);
            homes.put(vertex.key(), region);
            if (vertex instanceof ChartState state) {
                triggers.addAll(state.deferred());
                state.internal().forEach(arc -> triggers.addAll(arc.triggers()));
                state.connections().forEach(point -> vertices.put(point.key(), point));
                for (Region inner : state.regions()) {
                    owners.put(inner, state);
                    add(inner);
                }
            }
        }
    }

    /** The chart itself. */
    public Statechart chart() {
        return chart;
    }

    /** Every vertex, in no order. */
    public Iterable<Vertex> vertices() {
        return vertices.values();
    }

    /** The vertex with this key. */
    public Vertex vertex(String key) {
        Vertex vertex = vertices.get(key);
        if (vertex == null) {
            throw new IllegalArgumentException("a transition refers to " + key + ", which is not in the machine");
        }
        return vertex;
    }

    /** The region that contains the vertex; null for an entry or exit point. */
    public @Nullable Region home(String key) {
        return homes.get(key);
    }

    /** The state that contains the region; null for the chart itself. */
    public @Nullable ChartState owner(Region region) {
        return owners.get(region);
    }

    /** Whether the region contains the vertex, at any depth. */
    public boolean isWithin(String key, Region region) {
        Region outer = homes.get(key);
        while (outer != null && outer != region) {
            ChartState state = owners.get(outer);
            outer = state == null ? null : homes.get(state.key());
        }
        return outer == region;
    }

    /** Every transition that is not internal, in the order in which they are tried. */
    public List<Arc> arcs() {
        return arcs;
    }

    /** The transitions of a vertex that are not internal. */
    public List<Arc> leaving(String key) {
        return leaving.getOrDefault(key, List.of());
    }

    /** The events that are declared and occur nowhere. */
    public List<String> unused() {
        return chart.events().stream()
                .filter(event -> !triggers.contains(event))
                .toList();
    }

    /** The vertex's name and kind, for messages. */
    public static String label(Vertex vertex) {
        String kind = vertex instanceof Vertex.Pseudostate pseudostate
                ? pseudostate.kind().name().toLowerCase(Locale.ROOT).replace('_', ' ')
                : vertex instanceof ChartState ? "state" : "final state";
        return vertex.name().isEmpty() ? kind : kind + " " + Problems.quote(vertex.name());
    }
}
