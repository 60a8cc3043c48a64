package org.evoloop.models.format;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;
import org.jspecify.annotations.Nullable;

/**
 * Where PlantUML can draw the transitions of a chart. What is in a concurrent region, other than the first of its state,
 * can be named only there, and nothing else can be named there; such a region is called closed. Its own lines name only
 * what is directly in it.
 */
@SuppressWarnings("ReferenceEquality") // two regions may look alike
final class PlantUmlRegions {
    /** By the key of a vertex. */
    private final Map<String, Region> regions = new HashMap<>();

    private final IdentityHashMap<Region, Place> places = new IdentityHashMap<>();
    private final IdentityHashMap<Region, List<Drawn>> written = new IdentityHashMap<>();
    private final List<Drawn> acrossAll = new ArrayList<>();

    /** @param state that holds the region; empty at the top */
    private record Place(String state, boolean closed) {}

    /** A transition, and the vertices between which it is drawn. */
    record Drawn(Arc arc, String source, String target) {}

    PlantUmlRegions(Statechart chart) {
        enter(chart.regions(), "");
        places.keySet().forEach(region -> written.put(region, new ArrayList<>()));
        draw(chart.regions());
    }

    /** The transitions to write at the end of a region. */
    List<Drawn> writtenIn(Region region) {
        return written.getOrDefault(region, List.of());
    }

    /** The transitions to write at the end of the chart. */
    List<Drawn> acrossAll() {
        return acrossAll;
    }

    private void enter(List<Region> all, String state) {
        for (int i = 0; i < all.size(); i++) {
            Region region = all.get(i);
            places.put(region, new Place(state, i > 0 && !state.isEmpty()));
            for (Vertex vertex : region.vertices()) {
                regions.put(vertex.key(), region);
                if (vertex instanceof ChartState inner) {
                    inner.connections().forEach(point -> regions.put(point.key(), region));
                    enter(inner.regions(), inner.key());
                }
            }
        }
    }

    /** In the chart's order, which is that of the text. */
    private void draw(List<Region> all) {
        for (Region region : all) {
            region.vertices().stream()
                    .filter(ChartState.class::isInstance)
                    .forEach(vertex -> draw(((ChartState) vertex).regions()));
            region.arcs().stream()
                    .filter(arc -> arc.kind() != Arc.Kind.INTERNAL)
                    .forEach(arc -> draw(arc, region));
        }
    }

    private void draw(Arc arc, Region listed) {
        List<Region> around = closedAround(regions.get(arc.source()));
        List<Region> aroundTarget = closedAround(regions.get(arc.target()));
        int common = 0;
        while (common < Math.min(around.size(), aroundTarget.size())
                && around.get(common) == aroundTarget.get(common)) {
            common++;
        }
        String source = end(arc.source(), around, common);
        String target = end(arc.target(), aroundTarget, common);
        if (common > 0) {
            drawIn(around.get(common - 1), arc, source, target);
        } else if (closedAround(listed).isEmpty() && isIn(listed, source) && isIn(listed, target)) {
            writtenIn(listed).add(new Drawn(arc, source, target));
        } else {
            acrossAll.add(new Drawn(arc, source, target));
        }
    }

    /** In the innermost region around both ends; the lines of a closed one itself name only what is directly in it. */
    private void drawIn(Region closed, Arc arc, String source, String target) {
        Region inner = regions.getOrDefault(source, closed);
        while (inner != closed && !isIn(inner, target)) {
            inner = regions.getOrDefault(place(inner).state(), closed);
        }
        writtenIn(inner)
                .add(
                        inner == closed
                                ? new Drawn(arc, directlyIn(closed, source), directlyIn(closed, target))
                                : new Drawn(arc, source, target));
    }

    private String directlyIn(Region region, String key) {
        String outer = key;
        for (Region home = regions.get(key); home != null && home != region; home = regions.get(outer)) {
            outer = place(home).state();
        }
        return outer;
    }

    /** The vertex itself, or the state with the outermost closed region that the other end is not in. */
    private String end(String key, List<Region> around, int common) {
        return around.size() > common ? place(around.get(common)).state() : key;
    }

    /** The closed regions around this one and itself, the outermost first. */
    private List<Region> closedAround(@Nullable Region region) {
        List<Region> closed = new ArrayList<>();
        for (Region at = region; at != null; at = regions.get(place(at).state())) {
            if (place(at).closed()) {
                closed.add(0, at);
            }
        }
        return closed;
    }

    private boolean isIn(Region region, String key) {
        Region at = regions.get(key);
        while (at != null && at != region) {
            at = regions.get(place(at).state());
        }
        return at != null;
    }

    private Place place(Region region) {
        return places.getOrDefault(region, new Place("", false));
    }
}
