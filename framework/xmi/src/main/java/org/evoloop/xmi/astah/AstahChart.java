package org.evoloop.xmi.astah;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Place;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.xmi.astah.AstahXml.Actions;
import org.evoloop.xmi.astah.AstahXml.Element;
import org.evoloop.xmi.astah.AstahXml.FinalState;
import org.evoloop.xmi.astah.AstahXml.MachineReference;
import org.evoloop.xmi.astah.AstahXml.Pseudostate;
import org.evoloop.xmi.astah.AstahXml.State;
import org.evoloop.xmi.astah.AstahXml.StubState;
import org.evoloop.xmi.astah.AstahXml.SubmachineState;
import org.evoloop.xmi.dialect.Problems;
import org.jspecify.annotations.Nullable;

/** Turns the bindings of a machine, and of the machines it includes, into a {@link Statechart}. */
final class AstahChart {
    /** Limits nested submachines, whose elements multiply. */
    private static final int MAX_ELEMENTS = 500_000;

    private static final int MAX_INCLUSIONS = 100;

    private static final Map<String, Vertex.Kind> KINDS = Map.ofEntries(
            Map.entry("initial", Vertex.Kind.INITIAL),
            Map.entry("shallowhistory", Vertex.Kind.SHALLOW_HISTORY),
            Map.entry("deephistory", Vertex.Kind.DEEP_HISTORY),
            Map.entry("join", Vertex.Kind.JOIN),
            Map.entry("fork", Vertex.Kind.FORK),
            Map.entry("junction", Vertex.Kind.JUNCTION),
            Map.entry("choice", Vertex.Kind.CHOICE),
            Map.entry("entrypoint", Vertex.Kind.ENTRY_POINT),
            Map.entry("exitpoint", Vertex.Kind.EXIT_POINT),
            Map.entry("terminate", Vertex.Kind.TERMINATE));

    private final AstahFile file;
    private final Problems problems;
    /** Ids of the machines being read, from outermost to innermost. */
    private final Set<String> including = new HashSet<>();

    private int elementCount;

    AstahChart(AstahFile file, Problems problems) {
        this.file = file;
        this.problems = problems;
    }

    Statechart read(String title, AstahUnmarshaller.Result source) {
        List<Vertex.Pseudostate> borderPoints = new ArrayList<>();
        including.add(source.machine().id());
        List<Region> regions = machine(source, "", new HashMap<>(), borderPoints);
        boolean empty = regions.stream().allMatch(region -> region.vertices().isEmpty());
        if (empty && borderPoints.isEmpty() && problems.isEmpty()) {
            problems.add(0, "the diagram is empty; draw an initial pseudostate, states and transitions");
        }
        for (Vertex.Pseudostate point : borderPoints) {
            problems.add(
                    point.place().line(),
                    "pseudostate " + Problems.label(point.name(), point.place().id())
                            + " is an entry or exit point of the machine itself; draw an initial pseudostate or a final state"
                            + " in its place");
        }
        return new Statechart(title, place(source.machine()), regions, List.of());
    }

    /**
     * The regions of a machine; all its transitions are in the first one.
     *
     * @param prefix of the keys, so that a machine can be included more than once
     * @param byName receives the keys of the machine's vertices by name; empty keys for ambiguous names
     * @param borderPoints receives the entry and exit points of the machine itself
     */
    private List<Region> machine(
            AstahUnmarshaller.Result source,
            String prefix,
            Map<String, String> byName,
            List<Vertex.Pseudostate> borderPoints) {
        problems.addAll(source.problems());
        Scope scope = new Scope(prefix, byName, new AstahArcs(file, source, prefix, problems));
        List<State> tops = source.machine().tops.stream()
                .flatMap(role -> role.states.stream())
                .toList();
        tops.stream()
                .skip(1)
                .forEach(further -> problems.add(further.line, "second top state " + further.label() + "; keep one"));
        State top = tops.isEmpty() ? new State() : tops.get(0);
        refuseBehavior(top, "the top of a machine");
        List<Region> regions = regions(top, scope, borderPoints);
        List<AstahXml.Transition> transitions = source.machine().allTransitions();
        List<Arc> arcs = isTooLarge(transitions.size()) ? List.of() : scope.arcs.all(transitions);
        if (regions.isEmpty()) {
            return arcs.isEmpty() ? List.of() : List.of(new Region("", place(source.machine()), List.of(), arcs));
        }
        List<Region> all = new ArrayList<>(regions);
        Region first = all.get(0);
        all.set(0, new Region(first.name(), first.place(), first.vertices(), arcs));
        return all;
    }

    private boolean isTooLarge(int further) {
        if (elementCount > MAX_ELEMENTS) {
            return true;
        }
        elementCount += further;
        if (elementCount > MAX_ELEMENTS) {
            problems.add(
                    0,
                    "with its submachines the machine has more than " + MAX_ELEMENTS
                            + " states and transitions; include fewer of them");
            return true;
        }
        return false;
    }

    /** What the elements of one machine share. */
    private record Scope(String prefix, Map<String, String> byName, AstahArcs arcs) {
        String key(Element element) {
            return prefix + element.id();
        }
    }

    private List<Region> regions(State owner, Scope scope, List<Vertex.Pseudostate> borderPoints) {
        if (!owner.orthogonal()) {
            Region only = region("", owner, owner.substates(), scope, borderPoints);
            return only.vertices().isEmpty() ? List.of() : List.of(only);
        }
        List<Region> regions = new ArrayList<>();
        for (AstahXml.Vertex child : owner.substates()) {
            if (child instanceof State region && !region.orthogonal() && !(child instanceof SubmachineState)) {
                refuseBehavior(region, "a region");
                regions.add(region(region.name(), region, region.substates(), scope, borderPoints));
            } else if (child instanceof Pseudostate point && isBorderPoint(point)) {
                borderPoints.add((Vertex.Pseudostate) pseudostate(point, scope));
            } else {
                problems.add(
                        child.line,
                        child.word() + " " + child.label() + " stands between the regions of state " + owner.label()
                                + "; draw it inside one of them");
            }
        }
        return regions;
    }

    /** In Astah's files, the top and the regions are states, but no behavior can be drawn for them. */
    private void refuseBehavior(State region, String what) {
        List<Element> behavior = new ArrayList<>();
        List.of(region.entries, region.exits, region.doActivities)
                .forEach(roles -> roles.forEach(role -> behavior.addAll(role.actions)));
        behavior.addAll(region.internalTransitions());
        region.deferrable.forEach(role -> behavior.addAll(role.events));
        for (Element element : behavior) {
            problems.add(element.line, "behavior " + element.label() + " of " + what + "; draw it at a state");
        }
    }

    private Region region(
            String name,
            State owner,
            List<AstahXml.Vertex> elements,
            Scope scope,
            List<Vertex.Pseudostate> borderPoints) {
        List<Vertex> vertices = new ArrayList<>();
        for (AstahXml.Vertex element : elements) {
            if (isTooLarge(1)) {
                break;
            }
            if (element.id().isEmpty()) {
                problems.add(
                        element.line, element.word() + " " + element.label() + " has no id; export the model again");
                continue;
            }
            scope.arcs.addVertex(element.id());
            if (!element.name().isEmpty()) {
                scope.byName.merge(element.name(), scope.key(element), (one, other) -> "");
            }
            if (element instanceof Pseudostate point && isBorderPoint(point)) {
                borderPoints.add((Vertex.Pseudostate) pseudostate(point, scope));
            } else if (element instanceof Pseudostate other) {
                vertices.add(pseudostate(other, scope));
            } else if (element instanceof FinalState end) {
                vertices.add(new Vertex.FinalState(scope.key(end), end.name(), place(end)));
            } else if (element instanceof State state) {
                vertices.add(state(state, scope));
            } else {
                problems.add(
                        element.line,
                        element.word() + " " + element.label()
                                + " is not in a submachine state; draw its transitions to the state itself");
            }
        }
        return new Region(name, place(owner), vertices, List.of());
    }

    private static boolean isBorderPoint(Pseudostate pseudostate) {
        Vertex.Kind kind = kind(pseudostate);
        return kind == Vertex.Kind.ENTRY_POINT || kind == Vertex.Kind.EXIT_POINT;
    }

    private static Vertex.@Nullable Kind kind(Pseudostate pseudostate) {
        return pseudostate.kind == null ? null : KINDS.get(pseudostate.kind.toLowerCase(Locale.ROOT));
    }

    private Vertex pseudostate(Pseudostate pseudostate, Scope scope) {
        scope.arcs.addVertex(pseudostate.id());
        Vertex.Kind kind = kind(pseudostate);
        if (kind == null) {
            problems.add(
                    pseudostate.line,
                    "pseudostate " + pseudostate.label() + " of kind "
                            + Problems.quote(String.valueOf(pseudostate.kind))
                            + " is not known; draw one of UML's pseudostates in its place");
            kind = Vertex.Kind.JUNCTION;
        }
        return new Vertex.Pseudostate(scope.key(pseudostate), pseudostate.name(), place(pseudostate), kind);
    }

    private Vertex state(State state, Scope scope) {
        List<Vertex.Pseudostate> connections = new ArrayList<>();
        List<Region> regions = state instanceof SubmachineState submachineState
                ? submachine(submachineState, scope, connections)
                : regions(state, scope, connections);
        List<String> deferred = new ArrayList<>();
        state.deferrable.forEach(
                role -> role.events.forEach(event -> deferred.add(scope.arcs.eventName(event, state))));
        return new Vertex.ChartState(
                scope.key(state),
                problems.nameOrId(state.name(), place(state)),
                place(state),
                texts(state.entries),
                texts(state.exits),
                texts(state.doActivities),
                scope.arcs.internal(state),
                deferred,
                regions,
                connections);
    }

    private static List<String> texts(List<Actions> roles) {
        return roles.stream()
                .flatMap(role -> role.actions.stream())
                .map(Element::name)
                .filter(name -> !name.isEmpty())
                .toList();
    }

    private List<Region> submachine(SubmachineState state, Scope scope, List<Vertex.Pseudostate> connections) {
        List<MachineReference> references = state.submachines.stream()
                .flatMap(role -> role.machines.stream())
                .toList();
        String id = references.size() == 1 ? references.get(0).idref() : "";
        AstahUnmarshaller.Result included = file.machines().get(id);
        String refusal = "";
        if (included == null) {
            refusal = "is linked to " + (references.isEmpty() ? "no" : "the unknown") + " state machine"
                    + (id.isEmpty() ? "" : " " + Problems.quote(id)) + "; link it to one of this file";
        } else if (including.contains(id)) {
            refusal = "includes state machine " + included.machine().label() + ", which includes it; break the cycle";
        } else if (including.size() == MAX_INCLUSIONS) {
            refusal = "is the last of " + MAX_INCLUSIONS + " machines, each in another; include fewer of them";
        }
        if (included == null || !refusal.isEmpty()) {
            problems.add(state.line, "submachine state " + state.label() + " " + refusal);
            state.substates().forEach(child -> scope.arcs.addStub(child.id(), ""));
            return List.of();
        }
        Map<String, String> byName = new HashMap<>();
        including.add(id);
        List<Region> regions = machine(included, scope.key(state) + "/", byName, connections);
        including.remove(id);
        for (AstahXml.Vertex child : state.substates()) {
            if (child instanceof StubState stub) {
                stub(stub, state, byName, scope);
            } else {
                problems.add(
                        child.line,
                        child.word() + " " + child.label() + " stands in submachine state " + state.label()
                                + ", whose content is another machine; draw it there");
            }
        }
        return regions;
    }

    private void stub(StubState stub, SubmachineState owner, Map<String, String> byName, Scope scope) {
        String key = byName.get(stub.reference());
        if (key == null || key.isEmpty()) {
            problems.add(
                    stub.line,
                    "stub state " + stub.label() + " of submachine state " + owner.label() + " stands for "
                            + (key == null ? "no state" : "several states")
                            + " of the submachine; give it the name of one");
        }
        scope.arcs.addStub(stub.id(), key == null ? "" : key);
    }

    static Place place(Element element) {
        return new Place(element.id(), element.line);
    }
}
