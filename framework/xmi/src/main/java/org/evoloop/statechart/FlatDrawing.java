package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/**
 * Draws a flat machine as a chart that means the same, but for memories of states, and what is kept from state to state.
 * Several guards of a transition become a chain of junctions.
 *
 * <p>Threading: pure functions, which any thread may call.
 *
 * @since 0.1
 */
public final class FlatDrawing {
    private static final String INITIAL = "initial";

    private final StateMachine machine;
    private final List<Vertex> vertices = new ArrayList<>();
    private final List<Arc> arcs = new ArrayList<>();

    private FlatDrawing(StateMachine machine) {
        this.machine = machine;
    }

    /** The chart, of one region. */
    public static Statechart of(StateMachine machine) {
        return new FlatDrawing(machine).draw();
    }

    private Statechart draw() {
        vertices.add(new Pseudostate(INITIAL, "", Place.NONE, Kind.INITIAL));
        arcs.add(new Arc(
                Place.NONE,
                INITIAL,
                key(machine.initial()),
                List.of(),
                "",
                machine.initialEffects(),
                Arc.Kind.EXTERNAL));
        machine.states().forEach(state -> vertices.add(state(state)));
        machine.transitions().stream()
                .filter(transition -> !transition.internal())
                .forEach(this::arc);
        return new Statechart(
                machine.name(),
                Place.NONE,
                List.of(new Region("", Place.NONE, vertices, arcs)),
                machine.events().stream().map(Event::name).distinct().toList());
    }

    private static String key(State state) {
        return "state " + state.name();
    }

    private ChartState state(State state) {
        List<Arc> internal = machine.transitionsFrom(state).stream()
                .filter(Transition::internal)
                .map(transition -> new Arc(
                        Place.NONE,
                        key(state),
                        key(state),
                        List.of(drawn(transition.event())),
                        // An internal transition cannot have junctions.
                        String.join(" and ", transition.event().guards()),
                        transition.effects(),
                        Arc.Kind.INTERNAL))
                .toList();
        List<String> deferred = machine.deferred(state).stream()
                .filter(event -> event.guards().isEmpty())
                .map(Event::name)
                .toList();
        return new ChartState(
                key(state),
                DeviceUse.of(machine, state).mark(state.name()),
                Place.NONE,
                List.of(),
                List.of(),
                machine.activities(state),
                internal,
                deferred,
                List.of(),
                List.of());
    }

    private void arc(Transition transition) {
        List<String> guards = transition.event().guards();
        String from = key(transition.source());
        List<String> triggers = List.of(drawn(transition.event()));
        for (int i = 0; i < guards.size() - 1; i++) {
            String junction = "junction " + vertices.size();
            vertices.add(new Pseudostate(junction, "", Place.NONE, Kind.JUNCTION));
            arcs.add(new Arc(Place.NONE, from, junction, triggers, guards.get(i), List.of(), Arc.Kind.EXTERNAL));
            from = junction;
            triggers = List.of();
        }
        arcs.add(new Arc(
                Place.NONE,
                from,
                key(transition.target()),
                triggers,
                guards.isEmpty() ? "" : guards.get(guards.size() - 1),
                transition.effects(),
                Arc.Kind.EXTERNAL));
    }

    /** The event's name, with its keywords. */
    private String drawn(Event event) {
        return EventKeywords.drawn(machine, event.trigger());
    }
}
