package org.evoloop.xmi.uml2;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.DeviceUse;
import org.evoloop.statechart.Region;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.FinalState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;
import org.evoloop.xmi.dialect.ChartScope;
import org.evoloop.xmi.dialect.DeviceTexts;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.XmlNode;

/** Turns one machine into a chart. */
final class Uml2ChartReader {
    private static final Map<String, Kind> KINDS = Map.ofEntries(
            Map.entry("", Kind.INITIAL),
            Map.entry("initial", Kind.INITIAL),
            Map.entry("shallowHistory", Kind.SHALLOW_HISTORY),
            Map.entry("deepHistory", Kind.DEEP_HISTORY),
            Map.entry("join", Kind.JOIN),
            Map.entry("fork", Kind.FORK),
            Map.entry("junction", Kind.JUNCTION),
            Map.entry("choice", Kind.CHOICE),
            Map.entry("entryPoint", Kind.ENTRY_POINT),
            Map.entry("exitPoint", Kind.EXIT_POINT),
            Map.entry("terminate", Kind.TERMINATE));

    private final Uml2References references;
    private final Problems problems;
    private final Uml2Texts texts;
    private final Uml2Triggers triggers;
    private final Uml2Arcs arcs;

    Uml2ChartReader(Uml2References references, Problems problems) {
        this.references = references;
        this.problems = problems;
        this.texts = new Uml2Texts(references, problems);
        this.triggers = new Uml2Triggers(references, texts, problems);
        this.arcs = new Uml2Arcs(references, problems, texts, triggers);
    }

    Statechart read(Uml2Element machine, String title) {
        ChartScope<Uml2Element> scope = ChartScope.of(machine);
        new Uml2Vertices(references, problems).define(scope);
        List<Region> regions = content(scope);
        List<Pseudostate> points = points(machine, scope);
        if (!points.isEmpty() && !regions.isEmpty()) {
            // The points of a top-level machine are never used to enter or leave it, but their transitions must not be
            // lost.
            Region first = regions.get(0);
            List<Vertex> vertices = new ArrayList<>(first.vertices());
            vertices.addAll(points);
            regions = new ArrayList<>(regions);
            regions.set(0, new Region(first.name(), first.place(), vertices, first.arcs()));
        }
        return new Statechart(title, machine.place(), regions, List.of());
    }

    private List<Region> content(ChartScope<Uml2Element> scope) {
        Uml2Vocabulary.check(scope.machine(), problems);
        Map<XmlNode, List<Arc>> drawn = new HashMap<>();
        arcs(scope.machine(), scope, drawn);
        return regions(scope.machine(), scope, drawn);
    }

    /** Reads all transitions first, since a tool may put one anywhere. */
    private void arcs(Uml2Element owner, ChartScope<Uml2Element> scope, Map<XmlNode, List<Arc>> drawn) {
        for (Uml2Element region : owner.owned("region")) {
            for (Uml2Element transition : region.owned("transition")) {
                arcs.read(transition, scope).ifPresent(arc -> {
                    if (arc.kind() == Arc.Kind.INTERNAL) {
                        scope.addInternal(arc);
                    } else {
                        drawn.computeIfAbsent(region.node(), key -> new ArrayList<>())
                                .add(arc);
                    }
                });
                noteOthersThanGuards(transition);
            }
            region.owned("subvertex").forEach(vertex -> arcs(vertex, scope, drawn));
        }
    }

    private List<Region> regions(Uml2Element owner, ChartScope<Uml2Element> scope, Map<XmlNode, List<Arc>> drawn) {
        List<Region> regions = new ArrayList<>();
        for (Uml2Element region : owner.owned("region")) {
            Uml2Vocabulary.check(region, problems);
            List<Vertex> vertices = new ArrayList<>();
            for (Uml2Element vertex : region.owned("subvertex")) {
                if (!Uml2Vertices.isPoint(vertex)) {
                    vertex(vertex, scope, drawn).ifPresent(vertices::add);
                }
            }
            noteOthersThanGuards(region);
            regions.add(
                    new Region(region.name(), region.place(), vertices, drawn.getOrDefault(region.node(), List.of())));
        }
        return regions;
    }

    private Optional<Vertex> vertex(Uml2Element vertex, ChartScope<Uml2Element> scope, Map<XmlNode, List<Arc>> drawn) {
        Uml2Vocabulary.check(vertex, problems);
        return switch (Uml2Vertices.type(vertex)) {
            case "State" -> Optional.of(state(vertex, scope, drawn));
            case "FinalState" -> Optional.of(new FinalState(scope.key(vertex.id()), vertex.name(), vertex.place()));
            case "Pseudostate" -> pseudostate(vertex, scope).map(pseudostate -> pseudostate);
            default -> {
                problems.add(
                        vertex.place(),
                        "vertex " + vertex.label() + " is of type " + Problems.quote(vertex.type())
                                + ", which is not supported; draw a state or pseudostate");
                yield Optional.empty();
            }
        };
    }

    private Optional<Pseudostate> pseudostate(Uml2Element vertex, ChartScope<Uml2Element> scope) {
        Kind kind = KINDS.get(vertex.attribute("kind"));
        if (kind == null) {
            problems.add(
                    vertex.place(),
                    "pseudostate " + vertex.label() + " is of the unknown kind "
                            + Problems.quote(vertex.attribute("kind")) + "; use one of UML's kinds");
            return Optional.empty();
        }
        return Optional.of(new Pseudostate(scope.key(vertex.id()), vertex.name(), vertex.place(), kind));
    }

    private List<Pseudostate> points(Uml2Element owner, ChartScope<Uml2Element> scope) {
        return Uml2Vertices.points(owner).stream()
                .peek(point -> Uml2Vocabulary.check(point, problems))
                .flatMap(point -> pseudostate(point, scope).stream())
                .toList();
    }

    private ChartState state(Uml2Element state, ChartScope<Uml2Element> scope, Map<XmlNode, List<Arc>> arcsOf) {
        String name = problems.nameOrId(state.name(), state.place());
        List<Region> regions = regions(state, scope, arcsOf);
        List<Pseudostate> connections = new ArrayList<>(points(state, scope));
        Optional<ChartScope<Uml2Element>> submachine = scope.submachine(state.id());
        if (submachine.isPresent()) {
            if (!regions.isEmpty()) {
                problems.add(
                        state.place(),
                        "state " + state.label()
                                + " has regions and a submachine; move the regions into the submachine");
            }
            regions = content(submachine.get());
            connections.addAll(points(submachine.get().machine(), submachine.get()));
        }
        noteOthersThanGuards(state);
        ChartState drawn = new ChartState(
                scope.key(state.id()),
                name,
                state.place(),
                texts.behaviors(state, "entry"),
                texts.behaviors(state, "exit"),
                texts.behaviors(state, "doActivity"),
                scope.internal(scope.key(state.id())),
                triggers.names(state, "deferrableTrigger"),
                regions,
                connections);
        List<String> invariants = references.all(state, "stateInvariant").stream()
                .map(texts::constraint)
                .toList();
        return DeviceTexts.read(drawn, state.label(), invariants, problems);
    }

    /** A constraint is a guard, the device state of a state, or a remark. */
    private void noteOthersThanGuards(Uml2Element owner) {
        List<Uml2Element> rules = new ArrayList<>(owner.owned("ownedRule"));
        List<Uml2Element> invariant = references.all(owner, "stateInvariant");
        invariant.stream().filter(some -> !rules.contains(some)).forEach(rules::add);
        for (Uml2Element rule : rules) {
            boolean read = invariant.contains(rule)
                    && DeviceUse.parse(texts.constraint(rule)).isPresent();
            if (!texts.isGuard(rule) && !read) {
                problems.note(
                        rule.place(),
                        "constraint " + rule.label() + " of " + owner.type() + " " + owner.label()
                                + " is not a guard and is ignored; make it the guard of a transition if it should be one");
            }
        }
    }
}
