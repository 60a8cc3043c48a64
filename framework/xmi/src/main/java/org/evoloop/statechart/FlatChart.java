package org.evoloop.statechart;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * A chart that is already flat: simple states in one region, with transitions from state to state that have events and
 * no guards. The largest charts are of this kind, such as those made from tables. Nothing has to be explored; the result
 * is the same as that of {@link Explorer} and {@link FlatMachine}.
 *
 * <p>Threading: not thread-safe.
 */
final class FlatChart {
    private final Statechart chart;
    /** By their keys, in document order. */
    private final Map<String, Row> rows;

    /** By their names, since there are far fewer events than transitions. */
    private final Map<String, Event> events = new HashMap<>();

    private final Set<String> spontaneous = new LinkedHashSet<>();
    private final Set<String> urgent = new LinkedHashSet<>();
    private String initial = "";
    private @Nullable Arc start;
    private int transitions;

    private FlatChart(Statechart chart, Region region) {
        this.chart = chart;
        this.rows = new LinkedHashMap<>(2 * region.vertices().size());
    }

    /** A drawn state, and the transitions that leave it, in order. */
    private record Row(ChartState drawn, State state, List<Transition> leaving) {}

    /** The machine of a flat chart, with the drawn states; null if the chart is not flat, or has problems. */
    static @Nullable Flattening flatten(Statechart chart) {
        if (chart.regions().size() != 1) {
            return null;
        }
        Region region = chart.regions().get(0);
        FlatChart flat = new FlatChart(chart, region);
        return flat.takeStates(region.vertices()) && flat.takeArcs(region.arcs()) ? flat.flattening() : null;
    }

    /** Returns whether all are simple states, but for one initial pseudostate. */
    private boolean takeStates(List<Vertex> vertices) {
        Set<String> names = new HashSet<>(2 * vertices.size());
        for (Vertex vertex : vertices) {
            if (vertex instanceof ChartState state && isSimple(state) && names.add(state.name())) {
                rows.put(state.key(), new Row(state, new State(state.name()), new ArrayList<>()));
            } else if (vertex instanceof Pseudostate other && other.kind() == Kind.INITIAL && initial.isEmpty()) {
                initial = other.key();
            } else {
                return false;
            }
        }
        boolean differentKeys = rows.size() == names.size() && !rows.containsKey(initial);
        return differentKeys && rows.size() <= Explorer.MAX_STATES;
    }

    private static boolean isSimple(ChartState state) {
        return !state.name().isBlank()
                && !Keywords.isInName(state.name())
                && state.regions().isEmpty()
                && state.connections().isEmpty()
                && state.internal().isEmpty()
                && state.deferred().isEmpty()
                && state.doActivities().isEmpty();
    }

    /** Returns whether all lead from state to state on an event, but for the one to the first state. */
    private boolean takeArcs(List<Arc> arcs) {
        Row source = null;
        for (Arc arc : arcs) {
            Row target = rows.get(arc.target());
            if (target == null || !arc.guard().isEmpty() || arc.kind() != Arc.Kind.EXTERNAL) {
                return false;
            }
            // The transitions of a state are usually drawn one after the other.
            if (source == null || !source.drawn().key().equals(arc.source())) {
                source = rows.get(arc.source());
            }
            if (source != null ? !addAll(arc, source, target) : !begin(arc)) {
                return false;
            }
        }
        return start != null && transitions <= Explorer.MAX_MOVES;
    }

    /** Takes the transition to the first state; returns whether it is that. */
    private boolean begin(Arc arc) {
        boolean first =
                start == null && arc.source().equals(initial) && arc.triggers().isEmpty();
        start = arc;
        return first;
    }

    /** Adds a transition for each event; returns whether there is one at least, and none needs the general way. */
    private boolean addAll(Arc arc, Row source, Row target) {
        List<String> effects = PlainSteps.effects(
                source.drawn().exit(), arc.effects(), target.drawn().entry());
        for (int i = 0; i < arc.triggers().size(); i++) {
            Event event = event(arc.triggers().get(i));
            if (event == null) {
                return false;
            }
            source.leaving().add(new Transition(source.state(), event, target.state(), effects, false));
            transitions++;
        }
        spontaneous.addAll(arc.spontaneous());
        urgent.addAll(arc.urgent());
        return !arc.triggers().isEmpty();
    }

    /** Null for a time trigger, and for an event without a name. */
    private @Nullable Event event(String name) {
        Event known = events.get(name);
        if (known == null && !name.isBlank() && !Keywords.isBeforeEvent(name) && !NetBuilder.isTime(name)) {
            known = new Event(name);
            events.put(name, known);
        }
        return known;
    }

    /** Null if two transitions leave a state on the same event. */
    private @Nullable Flattening flattening() {
        Arc first = requireNonNull(start);
        StateMachineBuilder builder = StateMachine.named(chart.name());
        for (Row row : rows.values()) {
            State state = row.state();
            builder.drawn(state, state, List.of(), List.of(state.name()), false);
            DeviceUse use = row.drawn().use();
            use.sends().forEach(event -> builder.sends(state.name(), event));
            if (!use.device().isEmpty()) {
                builder.deviceState(state.name(), use.device());
            }
        }
        ChartState entered = requireNonNull(rows.get(first.target())).drawn();
        builder.initial(entered.name()).initialEffects(PlainSteps.effects(List.of(), first.effects(), entered.entry()));
        for (Row row : rows.values()) {
            builder.transitions(row.state(), row.leaving());
        }
        spontaneous.forEach(event -> builder.spontaneous(new Event(event)));
        urgent.forEach(event -> builder.urgent(new Event(event)));
        chart.events().stream().filter(event -> !event.isBlank()).forEach(event -> builder.event(new Event(event)));
        return builder.problems().isEmpty() ? new Flattening(builder.build(), this::leaves) : null;
    }

    private Map<State, List<Vertex>> leaves() {
        Map<State, List<Vertex>> leaves = new LinkedHashMap<>();
        rows.values().forEach(row -> leaves.put(row.state(), List.of(row.drawn())));
        return leaves;
    }
}
