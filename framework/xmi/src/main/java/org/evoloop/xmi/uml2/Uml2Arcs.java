package org.evoloop.xmi.uml2;

import java.util.List;
import java.util.Optional;
import org.evoloop.statechart.Arc;
import org.evoloop.xmi.dialect.ChartScope;
import org.evoloop.xmi.dialect.NamedCompletion;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.TransitionEnd;

/** Reads transitions. */
final class Uml2Arcs {
    private final Uml2References references;
    private final Problems problems;
    private final Uml2Texts texts;
    private final Uml2Triggers triggers;

    Uml2Arcs(Uml2References references, Problems problems, Uml2Texts texts, Uml2Triggers triggers) {
        this.references = references;
        this.problems = problems;
        this.texts = texts;
        this.triggers = triggers;
    }

    /** The transition; if it does not lead from a vertex to a vertex, reports a problem and returns nothing. */
    Optional<Arc> read(Uml2Element transition, ChartScope<Uml2Element> scope) {
        if (!transition.type().endsWith("Transition")) {
            problems.add(
                    transition.place(),
                    "element transition " + transition.label() + " is of type " + Problems.quote(transition.type())
                            + ", which is not supported; draw a transition");
            return Optional.empty();
        }
        Uml2Vocabulary.check(transition, problems);
        List<String> events = triggers.names(transition, "trigger");
        String guard = texts.guard(transition);
        List<String> effects = texts.behaviors(transition, "effect");
        Optional<String> source = end(transition, "source", scope);
        Optional<String> target = end(transition, "target", scope);
        if (source.isEmpty() || target.isEmpty()) {
            return Optional.empty();
        }
        references.all(transition, "source").stream()
                .filter(end -> Uml2Vertices.type(end).equals("State"))
                .forEach(state -> NamedCompletion.check(transition, state, events, problems));
        Arc.Kind kind = kind(transition, scope, source.get(), target.get());
        return Optional.of(new Arc(transition.place(), source.get(), target.get(), events, guard, effects, kind));
    }

    private Optional<String> end(Uml2Element transition, String role, ChartScope<Uml2Element> scope) {
        int before = problems.count();
        TransitionEnd words = new TransitionEnd(transition.label(), role);
        List<Uml2Element> ends = references.all(transition, role);
        if (ends.size() != 1) {
            if (problems.count() == before) {
                problems.add(transition.place(), words.notOne(ends.isEmpty()));
            }
            return Optional.empty();
        }
        Uml2Element end = ends.get(0);
        Optional<String> key = scope.find(end.id());
        List<String> points = key.isPresent() ? List.of() : pointsOfSubmachines(end.id(), scope);
        if (points.size() == 1) {
            return Optional.of(points.get(0));
        }
        if (key.isEmpty()) {
            problems.add(
                    transition.place(),
                    words.noVertex(
                            points.size() > 1
                                    ? "a point of a submachine that " + points.size() + " states share"
                                    : "the " + end.type() + " " + end.label()));
        }
        return key;
    }

    /** The keys of the entry or exit point with this id, in each submachine state that has it. */
    private static List<String> pointsOfSubmachines(String id, ChartScope<Uml2Element> scope) {
        return scope.submachines().stream()
                .filter(submachine -> Uml2Vertices.points(submachine.machine()).stream()
                        .anyMatch(point -> point.id().equals(id)))
                .flatMap(submachine -> submachine.find(id).stream())
                .toList();
    }

    /**
     * The kind as drawn, except for Enterprise Architect, which writes {@code local} on every transition whose kind the
     * author has not changed.
     */
    private Arc.Kind local(Uml2Element transition, ChartScope<Uml2Element> scope, String source, String target) {
        if (!transition.document().isBy("Enterprise Architect")
                || (!source.equals(target) && scope.isWithin(target, source))) {
            return Arc.Kind.LOCAL;
        }
        if (scope.isWithin(source, target)) {
            problems.note(
                    transition.place(),
                    "transition " + transition.label() + " is taken as external, though its kind is local, since "
                            + "Enterprise Architect writes that on every transition: it leaves and enters its state; "
                            + "make it internal if it should not");
        }
        return Arc.Kind.EXTERNAL;
    }

    private Arc.Kind kind(Uml2Element transition, ChartScope<Uml2Element> scope, String source, String target) {
        String kind = transition.attribute("kind");
        switch (kind) {
            case "", "external" -> {
                return Arc.Kind.EXTERNAL;
            }
            case "local" -> {
                return local(transition, scope, source, target);
            }
            case "internal" -> {
                if (!source.equals(target)) {
                    problems.add(
                            transition.place(),
                            "internal transition " + transition.label()
                                    + " leads to another state; draw it from its state to itself");
                }
                return Arc.Kind.INTERNAL;
            }
            default -> {
                problems.add(
                        transition.place(),
                        "transition " + transition.label() + " is of the unknown kind " + Problems.quote(kind)
                                + "; use internal, local or external");
                return Arc.Kind.EXTERNAL;
            }
        }
    }
}
