package org.evoloop.models.chart;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.DeviceUse;
import org.evoloop.statechart.Place;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/** A flat machine as a chart with one region, so that it can be shown like a drawn one. */
public final class FlatMachineChart {
    private static final String INITIAL = "initial";

    private FlatMachineChart() {}

    /** The chart; its states' keys are {@link #key(State)}. */
    public static Statechart of(StateMachine machine) {
        return of(
                machine.name(),
                machine.initial(),
                List.copyOf(machine.states()),
                machine.transitions(),
                state -> machine,
                machine.events().stream().map(Event::name).distinct().toList());
    }

    /**
     * A chart of any states and transitions, for example of two machines together.
     *
     * @param owner the machine that each state belongs to
     */
    public static Statechart of(
            String name,
            State initial,
            List<State> states,
            List<Transition> transitions,
            Function<State, StateMachine> owner,
            List<String> events) {
        List<Vertex> vertices = new ArrayList<>();
        vertices.add(new Vertex.Pseudostate(INITIAL, "", Place.NONE, Vertex.Kind.INITIAL));
        states.forEach(state -> vertices.add(state(state, transitions, owner.apply(state))));
        List<Arc> arcs = new ArrayList<>();
        arcs.add(new Arc(Place.NONE, INITIAL, key(initial), List.of(), "", List.of(), Arc.Kind.EXTERNAL));
        transitions.stream()
                .filter(transition -> !transition.internal())
                .forEach(transition -> arcs.add(arc(transition)));
        Region top = new Region("", Place.NONE, vertices, arcs);
        return new Statechart(name, Place.NONE, List.of(top), events);
    }

    private static Vertex.ChartState state(State state, List<Transition> transitions, StateMachine owner) {
        List<Arc> internal = transitions.stream()
                .filter(transition ->
                        transition.internal() && transition.source().equals(state))
                .map(FlatMachineChart::arc)
                .toList();
        return new Vertex.ChartState(
                key(state),
                state.name(),
                Place.NONE,
                List.of(),
                List.of(),
                List.of(),
                internal,
                owner.deferred(state).stream().map(Event::toString).toList(),
                List.of(),
                List.of(),
                DeviceUse.of(owner, state));
    }

    /** The arc of {@code transition}. */
    public static Arc arc(Transition transition) {
        return new Arc(
                Place.NONE,
                key(transition.source()),
                key(transition.target()),
                List.of(transition.event().name()),
                String.join("] [", transition.event().guards()),
                transition.effects(),
                transition.internal() ? Arc.Kind.INTERNAL : Arc.Kind.EXTERNAL);
    }

    /** The key of {@code state}. */
    public static String key(State state) {
        return "state " + state.name();
    }
}
