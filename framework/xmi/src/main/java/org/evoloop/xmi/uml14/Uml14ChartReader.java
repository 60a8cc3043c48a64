package org.evoloop.xmi.uml14;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.FinalState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;
import org.evoloop.xmi.dialect.ChartScope;
import org.evoloop.xmi.dialect.DeviceTexts;
import org.evoloop.xmi.dialect.NamedCompletion;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.TransitionEnd;

/** Turns one machine into a chart. */
final class Uml14ChartReader {
    /** {@code branch} is the name of a junction in UML 1.3. */
    private static final Map<String, Kind> KINDS = Map.of(
            "", Kind.INITIAL,
            "initial", Kind.INITIAL,
            "shallowHistory", Kind.SHALLOW_HISTORY,
            "deepHistory", Kind.DEEP_HISTORY,
            "join", Kind.JOIN,
            "fork", Kind.FORK,
            "junction", Kind.JUNCTION,
            "branch", Kind.JUNCTION,
            "choice", Kind.CHOICE);

    private static final List<String> ACTIONS =
            List.of("entry", "exit", "doActivity", "internalTransition", "deferrableEvent");

    private final Problems problems;
    private final Uml14Texts texts;

    Uml14ChartReader(Problems problems) {
        this.problems = problems;
        this.texts = new Uml14Texts(problems);
    }

    Statechart read(Uml14Element machine, String title) {
        if (Uml14Vertices.isActivityModelOfStates(machine)) {
            problems.add(
                    machine.line(),
                    "the states of a package stand in the ActivityModel " + machine.label()
                            + ", which is not supported; export XMI 2.1 instead");
            return new Statechart(title, machine.place(), List.of(), List.of());
        }
        ChartScope<Uml14Element> scope = ChartScope.of(machine);
        new Uml14Vertices(problems).define(scope);
        return new Statechart(title, machine.place(), content(scope), List.of());
    }

    private List<Region> content(ChartScope<Uml14Element> scope) {
        Uml14Vocabulary.check(scope.machine(), problems);
        List<Arc> arcs = new ArrayList<>();
        for (Uml14Element transition : scope.machine().owned("transitions")) {
            arc(transition, end(transition, "source", scope), end(transition, "target", scope), Arc.Kind.EXTERNAL)
                    .ifPresent(arc -> {
                        arcs.add(arc);
                        transition.all("source", problems).stream()
                                .filter(Uml14Vertices::isState)
                                .forEach(state -> NamedCompletion.check(transition, state, arc.triggers(), problems));
                    });
        }
        List<Region> regions = new ArrayList<>();
        for (Uml14Element top : Uml14Vertices.tops(scope.machine())) {
            Uml14Vocabulary.check(top, problems);
            refuseActions(top, "top state");
            regions.addAll(regions(top, scope));
        }
        if (!arcs.isEmpty() && !regions.isEmpty()) {
            Region first = regions.get(0);
            regions.set(0, new Region(first.name(), first.place(), first.vertices(), arcs));
        }
        return regions;
    }

    private List<Region> regions(Uml14Element state, ChartScope<Uml14Element> scope) {
        if (!Uml14Vertices.isConcurrent(state)) {
            List<Vertex> vertices = vertices(state, scope);
            return vertices.isEmpty() ? List.of() : List.of(new Region("", state.place(), vertices, List.of()));
        }
        List<Region> regions = new ArrayList<>();
        for (Uml14Element region : Uml14Vertices.inside(state)) {
            if (!region.type().equals("CompositeState") || Uml14Vertices.isConcurrent(region)) {
                problems.add(
                        region.line(),
                        region.type() + " " + region.label() + " stands directly in the concurrent state "
                                + state.label() + "; draw it in one of the state's regions");
            }
            Uml14Vocabulary.check(region, problems);
            refuseActions(region, "region");
            regions.add(new Region(region.name(), region.place(), vertices(region, scope), List.of()));
        }
        return regions;
    }

    private void refuseActions(Uml14Element state, String role) {
        for (String property : ACTIONS) {
            if (!state.owned(property).isEmpty()) {
                problems.add(
                        state.line(),
                        property + " of the " + role + " " + state.label()
                                + " is not supported; give it to a state in it or around it");
            }
        }
    }

    private List<Vertex> vertices(Uml14Element owner, ChartScope<Uml14Element> scope) {
        List<Vertex> vertices = new ArrayList<>();
        for (Uml14Element vertex : Uml14Vertices.inside(owner)) {
            vertex(vertex, scope).ifPresent(vertices::add);
        }
        return vertices;
    }

    private Optional<Vertex> vertex(Uml14Element vertex, ChartScope<Uml14Element> scope) {
        Uml14Vocabulary.check(vertex, problems);
        String key = scope.key(vertex.id());
        if (Uml14Vertices.isState(vertex)) {
            return Optional.of(state(vertex, key, scope));
        }
        switch (vertex.type()) {
            case "StubState" -> {
                return Optional.empty();
            }
            case "FinalState" -> {
                return Optional.of(new FinalState(key, vertex.name(), vertex.place()));
            }
            case "Pseudostate", "PseudoState" -> {
                String name = vertex.text("kind");
                Kind kind = KINDS.get(name);
                if (kind != null) {
                    return Optional.of(new Pseudostate(key, vertex.name(), vertex.place(), kind));
                }
                if (name.equals("final")) {
                    return Optional.of(new FinalState(key, vertex.name(), vertex.place()));
                }
                problems.add(
                        vertex.line(),
                        "pseudostate " + vertex.label() + " is of the unknown kind " + Problems.quote(name)
                                + "; use one of UML's kinds");
            }
            default ->
                problems.add(
                        vertex.line(),
                        vertex.type() + " " + vertex.label()
                                + " is not supported; draw states, pseudostates and final states");
        }
        return Optional.empty();
    }

    private ChartState state(Uml14Element state, String key, ChartScope<Uml14Element> scope) {
        String name = problems.nameOrId(state.name(), state.place());
        for (Uml14Element transition : state.owned("internalTransition")) {
            arc(transition, Optional.of(key), Optional.of(key), Arc.Kind.INTERNAL)
                    .ifPresent(scope::addInternal);
        }
        List<Region> regions = scope.submachine(state.id()).map(this::content).orElseGet(() -> regions(state, scope));
        ChartState drawn = new ChartState(
                key,
                name,
                state.place(),
                texts.actions(state, "entry"),
                texts.actions(state, "exit"),
                texts.actions(state, "doActivity"),
                scope.internal(key),
                texts.events(state, "deferrableEvent"),
                regions,
                List.of());
        return DeviceTexts.read(drawn, state.label(), state.stereotypes(), problems);
    }

    private Optional<Arc> arc(
            Uml14Element transition, Optional<String> source, Optional<String> target, Arc.Kind kind) {
        Uml14Vocabulary.check(transition, problems);
        List<String> events = texts.events(transition, "trigger");
        String guard = texts.guard(transition);
        List<String> effects = texts.actions(transition, "effect");
        return source.isEmpty() || target.isEmpty()
                ? Optional.empty()
                : Optional.of(new Arc(transition.place(), source.get(), target.get(), events, guard, effects, kind));
    }

    private Optional<String> end(Uml14Element transition, String role, ChartScope<Uml14Element> scope) {
        int before = problems.count();
        TransitionEnd words = new TransitionEnd(transition.label(), role);
        List<Uml14Element> ends = transition.all(role, problems);
        if (ends.size() != 1) {
            if (problems.count() == before) {
                problems.add(transition.line(), words.notOne(ends.isEmpty()));
            }
            return Optional.empty();
        }
        Optional<String> key = scope.find(ends.get(0).id());
        if (key.isEmpty()) {
            problems.add(
                    transition.line(),
                    words.noVertex(
                            "the " + ends.get(0).type() + " " + ends.get(0).label()));
        }
        return key;
    }
}
