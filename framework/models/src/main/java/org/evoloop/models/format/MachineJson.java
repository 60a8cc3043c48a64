package org.evoloop.models.format;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.evoloop.models.chart.ChartIndex;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.FinalState;
import org.evoloop.statechart.Vertex.Pseudostate;
import org.jspecify.annotations.Nullable;

/**
 * Machines as JSON, in the shape that docs/models.md promises: components are the keys, in this order.
 *
 * <p>Threading: immutable.
 */
public record MachineJson(List<Machine> machines) {

    /**
     * One machine. A flat machine has only the first five values; the others describe a hierarchical one.
     *
     * @param states names, including composite and final states
     * @param initial null if the machine has no initial state
     * @param initialTransitions the transitions of initial pseudostates, with their effects
     */
    public record Machine(
            String name,
            List<String> states,
            List<String> events,
            List<Transition> transitions,
            @Nullable String initial,
            List<Nesting> hierarchy,
            List<Part> regions,
            List<Point> pseudostates,
            List<Transition> initialTransitions) {}

    /** A transition for one trigger; null for missing parts. */
    public record Transition(
            String source,
            @Nullable String trigger,
            @Nullable String guard,
            @Nullable String effect,
            String target,
            String kind) {}

    /**
     * A state with its behaviors.
     *
     * @param parent null at the top level
     * @param device its device state, null if it has none
     * @param sends what its function may send
     */
    public record Nesting(
            String state,
            @Nullable String parent,
            boolean isFinal,
            List<String> entry,
            List<String> doActivities,
            List<String> exit,
            List<String> deferred,
            @Nullable String device,
            List<String> sends) {}

    /** A region; {@code state} is null for a region of the machine itself. */
    public record Part(
            @Nullable String state,
            @Nullable String name,
            List<String> states,
            @Nullable String initial) {}

    /** A pseudostate; {@code kind} is UML's term. */
    public record Point(String name, String kind, @Nullable String parent) {}

    /** The JSON text for {@code charts}. */
    public static String write(List<Statechart> charts) {
        return Json.write(
                new MachineJson(charts.stream().map(MachineJson::machine).toList()));
    }

    private static Machine machine(Statechart chart) {
        ChartIndex index = new ChartIndex(chart);
        List<Nesting> hierarchy = new ArrayList<>();
        List<Part> regions = new ArrayList<>();
        List<Point> points = new ArrayList<>();
        chart.regions().forEach(region -> regions.add(part("", region, index)));
        for (Vertex vertex : index.vertices()) {
            String name = index.name(vertex.key());
            String parent = index.parent(vertex.key());
            if (vertex instanceof ChartState state) {
                hierarchy.add(new Nesting(
                        name,
                        Json.orNull(parent),
                        false,
                        state.entry(),
                        state.doActivities(),
                        state.exit(),
                        state.deferred(),
                        Json.orNull(state.use().device()),
                        state.use().sends()));
                state.regions().forEach(region -> regions.add(part(name, region, index)));
            } else if (vertex instanceof FinalState end) {
                hierarchy.add(new Nesting(
                        name,
                        Json.orNull(parent),
                        true,
                        end.entry(),
                        List.of(),
                        end.exit(),
                        List.of(),
                        null,
                        List.of()));
            } else {
                points.add(new Point(name, ChartIndex.kind(vertex), Json.orNull(parent)));
            }
        }
        return new Machine(
                chart.name(),
                hierarchy.stream().map(Nesting::state).toList(),
                index.events(),
                transitions(index.transitions(), index),
                chart.regions().stream()
                        .map(index::initial)
                        .findFirst()
                        .map(Json::orNull)
                        .orElse(null),
                hierarchy,
                regions,
                points,
                transitions(index.initialTransitions(), index));
    }

    private static Part part(String state, Region region, ChartIndex index) {
        List<String> states = region.vertices().stream()
                .filter(vertex -> !(vertex instanceof Pseudostate))
                .map(vertex -> index.name(vertex.key()))
                .toList();
        return new Part(Json.orNull(state), Json.orNull(region.name()), states, Json.orNull(index.initial(region)));
    }

    private static List<Transition> transitions(List<Arc> arcs, ChartIndex index) {
        return arcs.stream().flatMap(arc -> transitions(arc, index).stream()).toList();
    }

    private static List<Transition> transitions(Arc arc, ChartIndex index) {
        List<String> triggers = arc.triggers().isEmpty() ? List.of("") : arc.triggers();
        return triggers.stream()
                .map(trigger -> new Transition(
                        index.name(arc.source()),
                        Json.orNull(trigger),
                        Json.orNull(arc.guard()),
                        Json.orNull(String.join("; ", arc.effects())),
                        index.name(arc.target()),
                        arc.kind().name().toLowerCase(Locale.ROOT)))
                .toList();
    }
}
