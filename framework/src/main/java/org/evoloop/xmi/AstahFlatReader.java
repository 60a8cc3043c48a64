package org.evoloop.xmi;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.xmi.AstahXml.Element;
import org.evoloop.xmi.AstahXml.End;
import org.evoloop.xmi.AstahXml.Event;
import org.evoloop.xmi.AstahXml.Pseudostate;
import org.evoloop.xmi.AstahXml.State;
import org.evoloop.xmi.AstahXml.Transition;
import org.evoloop.xmi.AstahXml.Vertex;
import org.jspecify.annotations.Nullable;

/** Turns the bindings of one machine into (E, S, T), if it is flat and complete. */
final class AstahFlatReader {
    private final AstahUnmarshaller.Result source;
    private final Map<String, String> eventNames;
    private final StateMachineBuilder builder;
    private final Problems problems;

    private final Map<String, Vertex> verticesById = new HashMap<>();
    private final Map<String, State> statesByName = new HashMap<>();
    private @Nullable Pseudostate initial;
    private @Nullable Transition initialTransition;

    AstahFlatReader(AstahUnmarshaller.Result source, Map<String, String> eventNames, StateMachineBuilder builder) {
        this.source = source;
        this.eventNames = eventNames;
        this.builder = builder;
        this.problems = new Problems(source.problems());
    }

    /** All that is wrong with the machine. */
    Problems read() {
        List<Vertex> vertices = topState().substates();
        if (vertices.isEmpty() && problems.isEmpty()) {
            problems.add("the diagram is empty; draw an initial pseudostate, states and transitions");
            return problems;
        }
        for (Vertex vertex : vertices) {
            verticesById.put(vertex.id(), vertex);
            if (vertex instanceof State state) {
                state(state);
            } else if (vertex instanceof Pseudostate pseudostate) {
                pseudostate(pseudostate);
            }
        }
        source.machine().transitions.forEach(role -> role.transitions.forEach(this::transition));
        requireInitialState();
        builder.problems().forEach(problems::add);
        return problems;
    }

    /** The machine that {@link #read} found no problem with. */
    StateMachine machine() {
        return builder.build();
    }

    private State topState() {
        List<State> tops = source.machine().tops.stream()
                .flatMap(role -> role.states.stream())
                .toList();
        for (State further : tops.stream().skip(1).toList()) {
            problems.add(further.line, "second top state " + further.label() + "; keep one");
        }
        State top = tops.isEmpty() ? new State() : tops.get(0);
        refuseRegions(top);
        return top;
    }

    private void state(State state) {
        refuseNesting(state, false);
        String name = state.name();
        if (name.isEmpty()) {
            problems.add(state.line, "state without a name (id " + Problems.quote(state.id()) + "); give it one");
            return;
        }
        State namesake = statesByName.putIfAbsent(name, state);
        if (namesake == null) {
            builder.state(name);
        } else {
            problems.add(
                    state.line,
                    "state " + state.label() + " has the name of the state in line " + namesake.line + " (id "
                            + Problems.quote(namesake.id()) + "); rename one of them");
        }
    }

    /** @param region whether the state is a region of an orthogonal state, which is a problem already */
    private void refuseNesting(State state, boolean region) {
        refuseRegions(state);
        List<Vertex> substates = state.substates();
        if (!substates.isEmpty() && !state.orthogonal() && !region) {
            problems.add(
                    state.line,
                    "composite state " + state.label() + " is not supported; draw its " + substates.size()
                            + " inner elements outside of any state");
        }
        for (Vertex inner : substates) {
            verticesById.put(inner.id(), inner);
            if (inner instanceof State innerState) {
                refuseNesting(innerState, state.orthogonal());
            } else if (inner instanceof Pseudostate pseudostate && !pseudostate.initial()) {
                refuse(pseudostate);
            }
        }
    }

    private void refuseRegions(State state) {
        if (state.orthogonal()) {
            problems.add(
                    state.line,
                    "orthogonal regions in state " + state.label()
                            + " are not supported; draw a machine without parallel regions");
        }
    }

    private void pseudostate(Pseudostate pseudostate) {
        if (!pseudostate.initial()) {
            refuse(pseudostate);
        } else if (initial == null) {
            initial = pseudostate;
        } else {
            problems.add(
                    pseudostate.line,
                    "second initial pseudostate " + pseudostate.label() + ", the first is in line " + initial.line
                            + "; keep one");
        }
    }

    private void refuse(Pseudostate pseudostate) {
        problems.add(
                pseudostate.line,
                "pseudostate " + pseudostate.label() + " of kind " + Problems.quote(String.valueOf(pseudostate.kind))
                        + " is not supported; draw states and one initial pseudostate alone");
    }

    private void transition(Transition transition) {
        Vertex from = end(transition, transition.sources, "source");
        Vertex to = end(transition, transition.targets, "target");
        if (to instanceof Pseudostate pseudostate && pseudostate.initial()) {
            problems.add(
                    transition.line,
                    "transition " + transition.label() + " ends in the initial pseudostate; end it in a state");
        }
        if (from instanceof Pseudostate pseudostate) {
            if (pseudostate == initial) {
                initialTransition(transition, to);
            }
            return;
        }
        String event = event(transition);
        if (!event.isEmpty() && !stateName(from).isEmpty() && !stateName(to).isEmpty()) {
            builder.transition(stateName(from), event, stateName(to), "line " + transition.line);
        }
    }

    /** The name of a state that can be used; empty for anything else, which is a problem already. */
    private String stateName(@Nullable Vertex vertex) {
        return vertex instanceof State state && statesByName.get(state.name()) == state ? state.name() : "";
    }

    private void initialTransition(Transition transition, @Nullable Vertex target) {
        transition
                .events()
                .forEach(event -> problems.add(
                        event.line,
                        "trigger " + event.label()
                                + " of the transition from the initial pseudostate is not supported; remove it"));
        if (initialTransition != null) {
            problems.add(
                    transition.line,
                    "second transition " + transition.label() + " from the initial pseudostate, the first is in line "
                            + initialTransition.line + "; keep one");
            return;
        }
        initialTransition = transition;
        if (!stateName(target).isEmpty()) {
            builder.initial(stateName(target));
        }
    }

    private void requireInitialState() {
        if (initial == null) {
            problems.add("no initial pseudostate; draw one with a transition to the first state");
        } else if (initialTransition == null) {
            problems.add(
                    initial.line,
                    "no transition leaves the initial pseudostate " + initial.label()
                            + "; draw one to the first state");
        }
    }

    /** The vertex at this end; null if there is none, which is then a problem. */
    private @Nullable Vertex end(Transition transition, List<End> ends, String role) {
        List<String> ids = ends.stream()
                .flatMap(end -> end.vertices.stream())
                .map(Element::idref)
                .toList();
        if (ids.size() != 1 || ids.get(0).isEmpty()) {
            problems.add(
                    transition.line,
                    "transition " + transition.label() + " has " + ids.size() + " " + role
                            + " states; draw it from one state to one state");
            return null;
        }
        Vertex vertex = verticesById.get(ids.get(0));
        if (vertex == null && source.definedIds().contains(ids.get(0))) {
            problems.add(
                    transition.line,
                    "the " + role + " of transition " + transition.label() + " is no state but the element with the id "
                            + Problems.quote(ids.get(0)) + "; draw it from state to state");
        }
        return vertex;
    }

    /** The event's name; empty if there is not exactly one, which is then a problem. */
    private String event(Transition transition) {
        List<Event> events = transition.events();
        if (events.size() != 1) {
            problems.add(
                    transition.line,
                    events.isEmpty()
                            ? "transition " + transition.label() + " has no trigger; give it an event"
                            : "transition " + transition.label() + " has " + events.size()
                                    + " triggers; draw a transition for each");
            return "";
        }
        Event event = events.get(0);
        String name = event.idref().isEmpty() ? event.name() : eventNames.get(event.idref());
        if (name == null) {
            problems.add(
                    event.line,
                    "the trigger of transition " + transition.label() + " refers to the unknown event id "
                            + Problems.quote(event.idref()) + "; export the model again, or correct the id");
            return "";
        }
        if (name.isEmpty()) {
            problems.add(event.line, "the trigger of transition " + transition.label() + " has no name; give it one");
        }
        return name;
    }
}
