package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;
import org.jspecify.annotations.Nullable;

/** An {@link Interpreter}'s view of a statechart. */
final class Drawing {
    /** In an event, separates the text from the name of the state to whose timer or activity it belongs. */
    static final String OWNER = "@";

    final List<Arc> arcs = new ArrayList<>();
    /** Keys of the vertices in document order. */
    final List<String> order = new ArrayList<>();

    private final Map<String, Vertex> byKey = new HashMap<>();
    private final Map<String, List<Region>> around = new HashMap<>();
    private final Map<String, ChartState> borderOf = new HashMap<>();

    Drawing(Statechart chart) {
        chart.regions().forEach(region -> learn(region, List.of()));
    }

    /** The regions around a vertex, the outermost first. */
    List<Region> around(Vertex vertex) {
        return Objects.requireNonNull(around.get(vertex.key()));
    }

    Region home(Vertex vertex) {
        List<Region> regions = around(vertex);
        return regions.get(regions.size() - 1);
    }

    /** The state on whose border an entry or exit point is. */
    ChartState border(Vertex point) {
        return Objects.requireNonNull(borderOf.get(point.key()));
    }

    private void learn(Region region, List<Region> outer) {
        List<Region> here = Stream.concat(outer.stream(), Stream.of(region)).toList();
        arcs.addAll(region.arcs());
        for (Vertex vertex : region.vertices()) {
            byKey.put(vertex.key(), vertex);
            around.put(vertex.key(), here);
            order.add(vertex.key());
            if (vertex instanceof ChartState state) {
                arcs.addAll(state.internal());
                state.connections().forEach(point -> {
                    byKey.put(point.key(), point);
                    around.put(point.key(), here);
                    borderOf.put(point.key(), state);
                });
                state.regions().forEach(inner -> learn(inner, here));
            }
        }
    }

    Vertex vertex(String key) {
        return Objects.requireNonNull(byKey.get(key));
    }

    ChartState state(String key) {
        return (ChartState) vertex(key);
    }

    Stream<Arc> leaving(Vertex vertex) {
        return arcs.stream().filter(arc -> arc.source().equals(vertex.key()));
    }

    Stream<Arc> entering(Vertex vertex) {
        return arcs.stream().filter(arc -> arc.target().equals(vertex.key()));
    }

    boolean is(Vertex vertex, Kind kind) {
        return vertex instanceof Pseudostate pseudostate && pseudostate.kind() == kind;
    }

    static boolean contains(List<Region> regions, Region wanted) {
        return regions.stream().anyMatch(region -> region == wanted);
    }

    boolean isInside(ChartState outer, Vertex inner) {
        return outer.regions().stream().anyMatch(region -> contains(around(inner), region));
    }

    /** The region whose states a transition leaves and enters. */
    Region scope(Arc arc) {
        Region scope = ownScope(arc);
        if (!is(vertex(arc.target()), Kind.FORK)) {
            return scope;
        }
        for (Arc branch : leaving(vertex(arc.target())).toList()) {
            scope = common(inside(scope), around(vertex(branch.target())));
        }
        return scope;
    }

    /** A region and those around it, the outermost first. */
    private List<Region> inside(Region region) {
        return around.values().stream()
                .filter(regions -> regions.get(regions.size() - 1) == region)
                .findFirst()
                .orElseThrow();
    }

    private Region ownScope(Arc arc) {
        Vertex target = vertex(arc.target());
        if (is(target, Kind.JOIN)) {
            return entering(target)
                    .map(segment -> common(around(vertex(segment.source())), around(target)))
                    .min(Comparator.comparingInt(region -> depth(region)))
                    .orElseThrow();
        }
        @Nullable
        ChartState from = arc.kind() == Arc.Kind.LOCAL && vertex(arc.source()) instanceof ChartState state
                ? state
                : is(vertex(arc.source()), Kind.ENTRY_POINT) ? border(vertex(arc.source())) : null;
        @Nullable
        ChartState to = is(target, Kind.EXIT_POINT)
                ? border(target)
                : arc.kind() == Arc.Kind.LOCAL && target instanceof ChartState outer ? outer : null;
        for (Region region : from == null ? List.<Region>of() : from.regions()) {
            if (contains(around(target), region)) {
                return region;
            }
        }
        for (Region region : to == null ? List.<Region>of() : to.regions()) {
            if (contains(around(vertex(arc.source())), region)) {
                return region;
            }
        }
        return common(around(vertex(arc.source())), around(target));
    }

    /** The state that a local transition to itself does not leave; null for all others. */
    static @Nullable String loop(Arc arc) {
        return arc.kind() == Arc.Kind.LOCAL && arc.source().equals(arc.target()) ? arc.source() : null;
    }

    int depth(Region region) {
        return around.values().stream()
                .filter(regions -> regions.get(regions.size() - 1) == region)
                .mapToInt(List::size)
                .findFirst()
                .orElse(0);
    }

    static Region common(List<Region> some, List<Region> others) {
        Region last = some.get(0);
        for (int i = 0; i < Math.min(some.size(), others.size()) && some.get(i) == others.get(i); i++) {
            last = some.get(i);
        }
        return last;
    }

    ChartState ownerOf(Region region) {
        return byKey.values().stream()
                .filter(ChartState.class::isInstance)
                .map(ChartState.class::cast)
                .filter(state -> contains(state.regions(), region))
                .findFirst()
                .orElseThrow();
    }

    static boolean isTime(String trigger) {
        return trigger.startsWith("tm(");
    }

    /** The event of the flat machine as this interpreter calls it. */
    static String drawn(String event) {
        return event.replaceAll("completion\\((.*)\\)", "completion in $1")
                .replace(" in ", OWNER)
                .replace(OWNER + "S", OWNER + "s");
    }
}
