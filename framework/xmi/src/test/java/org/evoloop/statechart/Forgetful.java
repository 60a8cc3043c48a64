package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;

/** Charts with many histories, and the same charts without: transitions to a history lead to the state around it. */
final class Forgetful {
    private final Map<String, String> ownerOfHistory = new LinkedHashMap<>();
    private final List<Arc> ways = new ArrayList<>();

    private Forgetful() {}

    static Statechart copy(Statechart chart) {
        Forgetful forgetful = new Forgetful();
        List<Region> regions = forgetful.regions(chart.regions(), "");
        return new Statechart(
                chart.name(),
                chart.place(),
                regions.stream().map(forgetful::redirected).toList(),
                chart.events());
    }

    private List<Region> regions(List<Region> regions, String owner) {
        return regions.stream().map(region -> region(region, owner)).toList();
    }

    private Region region(Region region, String owner) {
        List<String> inner = states(region);
        for (int i = 0; i < inner.size() && inner.size() > 1; i++) {
            way(inner.get(i), inner.get((i + 1) % inner.size()), owner.isEmpty() ? "round" : "next");
        }
        List<Vertex> vertices = new ArrayList<>();
        for (Vertex vertex : region.vertices()) {
            if (vertex instanceof Pseudostate pseudostate
                    && (pseudostate.kind() == Kind.SHALLOW_HISTORY || pseudostate.kind() == Kind.DEEP_HISTORY)) {
                ownerOfHistory.put(vertex.key(), owner);
            } else if (vertex instanceof ChartState state) {
                vertices.add(new ChartState(
                        state.key(),
                        state.name(),
                        state.place(),
                        state.entry(),
                        state.exit(),
                        state.doActivities(),
                        state.internal(),
                        state.deferred(),
                        regions(state.regions(), state.key()),
                        state.connections()));
            } else {
                vertices.add(vertex);
            }
        }
        return new Region(region.name(), region.place(), vertices, region.arcs());
    }

    private Region redirected(Region top) {
        List<Arc> arcs = top.arcs().stream()
                .filter(arc -> !ownerOfHistory.containsKey(arc.source()))
                .map(arc -> new Arc(
                        arc.place(),
                        arc.source(),
                        ownerOfHistory.getOrDefault(arc.target(), arc.target()),
                        arc.triggers(),
                        arc.guard(),
                        arc.effects(),
                        arc.kind()))
                .toList();
        return new Region(top.name(), top.place(), top.vertices(), arcs);
    }

    /**
     * The chart with added transitions, round each region and from each state of the top region to each history; empty
     * if it has no history.
     */
    static Optional<Statechart> busier(Statechart chart) {
        Forgetful forgetful = new Forgetful();
        forgetful.regions(chart.regions(), "");
        List<String> tops = states(chart.regions().get(0));
        List<String> histories = List.copyOf(forgetful.ownerOfHistory.keySet());
        for (String history : histories) {
            tops.forEach(top -> forgetful.way(top, history, "back" + histories.indexOf(history)));
        }
        List<Region> regions = new ArrayList<>(chart.regions());
        Region top = regions.get(0);
        List<Arc> arcs = new ArrayList<>(top.arcs());
        arcs.addAll(forgetful.ways);
        regions.set(0, new Region(top.name(), top.place(), top.vertices(), arcs));
        return histories.isEmpty()
                ? Optional.empty()
                : Optional.of(new Statechart(chart.name(), chart.place(), regions, chart.events()));
    }

    private static List<String> states(Region region) {
        return region.vertices().stream()
                .filter(ChartState.class::isInstance)
                .map(Vertex::key)
                .toList();
    }

    private void way(String source, String target, String event) {
        ways.add(new Arc(Place.NONE, source, target, List.of(event), "", List.of(), Arc.Kind.EXTERNAL));
    }
}
