package org.evoloop.models.chart;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
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
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;

/**
 * All elements of a chart, in its order and at any depth, each with a unique name. A state has its own name if that is
 * unique, else its path {@code Outer.Inner}. A pseudostate without a unique name gets one made from its kind.
 *
 * <p>Threading: immutable.
 */
public final class ChartIndex {
    private final Map<String, Vertex> vertices = new LinkedHashMap<>();
    private final Map<String, String> paths = new HashMap<>();
    private final Map<String, String> parents = new HashMap<>();
    private final Map<String, String> names = new HashMap<>();
    private final List<Arc> arcs = new ArrayList<>();
    private final Map<String, List<Arc>> leaving = new HashMap<>();
    private final Map<String, Integer> numbers = new HashMap<>();
    private final Set<String> events = new LinkedHashSet<>();

    public ChartIndex(Statechart chart) {
        chart.regions().forEach(region -> collect(region, "", ""));
        arcs.forEach(arc ->
                leaving.computeIfAbsent(arc.source(), key -> new ArrayList<>()).add(arc));
        nameStates();
        nameOthers();
        events.addAll(chart.events());
        arcs.forEach(arc -> events.addAll(arc.triggers()));
        states().forEach(state -> events.addAll(state.deferred()));
    }

    private void collect(Region region, String parent, String path) {
        for (Vertex vertex : region.vertices()) {
            String ownPath = path.isEmpty() ? vertex.name() : path + "." + vertex.name();
            add(vertex, parent, ownPath);
            if (vertex instanceof ChartState state) {
                arcs.addAll(state.internal());
                state.connections().forEach(point -> add(point, state.key(), ownPath + "." + point.name()));
                state.regions().forEach(inner -> collect(inner, state.key(), ownPath));
            }
        }
        arcs.addAll(region.arcs());
    }

    private void add(Vertex vertex, String parent, String path) {
        vertices.put(vertex.key(), vertex);
        parents.put(vertex.key(), parent);
        paths.put(vertex.key(), path);
    }

    private void nameStates() {
        Map<String, Integer> uses = new HashMap<>();
        states().forEach(state -> uses.merge(state.name(), 1, Integer::sum));
        Set<String> taken = new HashSet<>();
        for (ChartState state : states()) {
            boolean unique = uses.getOrDefault(state.name(), 0) == 1;
            String wanted = unique ? state.name() : paths.getOrDefault(state.key(), state.name());
            names.put(state.key(), free(wanted, taken));
        }
    }

    private void nameOthers() {
        Set<String> taken = new HashSet<>(names.values());
        for (Vertex vertex : vertices.values()) {
            if (!(vertex instanceof ChartState)) {
                names.put(vertex.key(), free(vertex.name().isEmpty() ? kind(vertex) : vertex.name(), taken));
            }
        }
    }

    private String free(String wanted, Set<String> taken) {
        String name = wanted;
        while (!taken.add(name)) {
            name = wanted + " " + numbers.merge(wanted, 2, (last, first) -> last + 1);
        }
        return name;
    }

    /** The kind of a vertex, in UML's words: {@code state}, {@code final}, {@code shallowHistory} and so on. */
    public static String kind(Vertex vertex) {
        if (vertex instanceof Pseudostate pseudostate) {
            String[] words = pseudostate.kind().name().toLowerCase(Locale.ROOT).split("_", -1);
            StringBuilder kind = new StringBuilder(words[0]);
            for (int i = 1; i < words.length; i++) {
                kind.append(Character.toUpperCase(words[i].charAt(0))).append(words[i].substring(1));
            }
            return kind.toString();
        }
        return vertex instanceof ChartState ? "state" : "final";
    }

    /** Whether {@code vertex} is an initial pseudostate. */
    public static boolean isInitial(Vertex vertex) {
        return vertex instanceof Pseudostate pseudostate && pseudostate.kind() == Kind.INITIAL;
    }

    /** Every vertex; outer ones come before the vertices inside them. */
    public Collection<Vertex> vertices() {
        return List.copyOf(vertices.values());
    }

    /** Every state, including composite ones. */
    public List<ChartState> states() {
        return vertices.values().stream()
                .filter(ChartState.class::isInstance)
                .map(ChartState.class::cast)
                .toList();
    }

    /** Every transition, including internal ones and those of initial pseudostates. */
    public List<Arc> arcs() {
        return List.copyOf(arcs);
    }

    /** Every transition of the vertex {@code key}, including internal ones. */
    public List<Arc> leaving(String key) {
        return leaving.getOrDefault(key, List.of());
    }

    /** Every transition except those of initial pseudostates. */
    public List<Arc> transitions() {
        return arcs.stream().filter(arc -> !isInitial(vertex(arc.source()))).toList();
    }

    /** The transitions of initial pseudostates. */
    public List<Arc> initialTransitions() {
        return arcs.stream().filter(arc -> isInitial(vertex(arc.source()))).toList();
    }

    /** The names of all events, declared ones first. */
    public List<String> events() {
        return List.copyOf(events);
    }

    /** The unique name of the vertex {@code key}. */
    public String name(String key) {
        return names.getOrDefault(vertex(key).key(), key);
    }

    /** The key of the state that contains the vertex {@code key}; empty at the top level. */
    public String parentKey(String key) {
        return parents.getOrDefault(key, "");
    }

    /** The name of the state that contains the vertex {@code key}; empty at the top level. */
    public String parent(String key) {
        String parent = parentKey(key);
        return parent.isEmpty() ? "" : name(parent);
    }

    /** The vertex {@code key}. */
    public Vertex vertex(String key) {
        Vertex vertex = vertices.get(key);
        if (vertex == null) {
            throw new IllegalArgumentException("a transition refers to " + key + ", which is not in the machine");
        }
        return vertex;
    }

    /** The name of the vertex in which {@code region} starts; empty if no initial pseudostate leads to one. */
    public String initial(Region region) {
        return region.vertices().stream()
                .filter(ChartIndex::isInitial)
                .flatMap(initial -> leaving(initial.key()).stream())
                .findFirst()
                .map(arc -> name(arc.target()))
                .orElse("");
    }
}
