package org.evoloop.xmi.astah;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.statechart.Arc;
import org.evoloop.xmi.astah.AstahXml.Element;
import org.evoloop.xmi.astah.AstahXml.End;
import org.evoloop.xmi.astah.AstahXml.Event;
import org.evoloop.xmi.astah.AstahXml.State;
import org.evoloop.xmi.astah.AstahXml.Transition;
import org.evoloop.xmi.dialect.Condition;
import org.evoloop.xmi.dialect.Problems;

/** Turns the transitions of one machine into {@link Arc arcs}. */
final class AstahArcs {
    private final AstahFile file;
    private final Set<String> definedIds;
    private final String prefix;
    private final Problems problems;
    private final Map<String, String> keysById = new HashMap<>();

    /** @param prefix of the keys of the machine's vertices */
    AstahArcs(AstahFile file, AstahUnmarshaller.Result source, String prefix, Problems problems) {
        this.file = file;
        this.definedIds = source.definedIds();
        this.prefix = prefix;
        this.problems = problems;
    }

    void addVertex(String id) {
        keysById.put(id, prefix + id);
    }

    /**
     * @param key of the vertex of another machine that it refers to; empty if there is none, which has already been
     *     reported
     */
    void addStub(String id, String key) {
        keysById.put(id, key);
    }

    /** The transitions between vertices. All vertices must have been added. */
    List<Arc> all(List<Transition> transitions) {
        List<Arc> arcs = new ArrayList<>();
        for (Transition transition : transitions) {
            String source = end(transition, transition.sources, "source");
            String target = end(transition, transition.targets, "target");
            if (!source.isEmpty() && !target.isEmpty()) {
                arcs.add(arc(transition, source, target, Arc.Kind.EXTERNAL));
            }
        }
        return arcs;
    }

    /** The internal transitions of a state. */
    List<Arc> internal(State state) {
        List<Arc> arcs = new ArrayList<>();
        for (Transition transition : state.internalTransitions()) {
            List<End> ends = new ArrayList<>(transition.sources);
            ends.addAll(transition.targets);
            if (ids(ends).stream().anyMatch(id -> !id.equals(state.id()))) {
                problems.add(
                        transition.line,
                        "internal transition " + transition.label() + " of state " + state.label()
                                + " leads from or to another state; begin and end it there");
            }
            String key = prefix + state.id();
            arcs.add(arc(transition, key, key, Arc.Kind.INTERNAL));
        }
        return arcs;
    }

    /** The key of the vertex at this end; if there is none, reports a problem and returns an empty text. */
    private String end(Transition transition, List<End> ends, String role) {
        List<String> ids = ids(ends);
        if (ids.size() != 1 || ids.get(0).isEmpty()) {
            problems.add(
                    transition.line,
                    "transition " + transition.label() + " has " + ids.size() + " " + role
                            + " states; draw it from one state to one state");
            return "";
        }
        String key = keysById.get(ids.get(0));
        if (key == null && definedIds.contains(ids.get(0))) {
            problems.add(
                    transition.line,
                    "the " + role + " of transition " + transition.label()
                            + " is not a state but the element with the id " + Problems.quote(ids.get(0))
                            + "; draw it from state to state");
        }
        return key == null ? "" : key;
    }

    private static List<String> ids(List<End> ends) {
        return ends.stream()
                .flatMap(end -> end.vertices.stream())
                .map(Element::idref)
                .toList();
    }

    private Arc arc(Transition transition, String source, String target, Arc.Kind kind) {
        List<String> triggers = new ArrayList<>();
        for (AstahXml.Events role : transition.triggers) {
            for (Event event : role.events) {
                String name = eventName(event, transition);
                if (!name.isEmpty()) {
                    triggers.add(name);
                }
            }
        }
        String guard = guard(transition);
        List<String> effects = transition.effects.stream()
                .flatMap(role -> role.actions.stream())
                .map(Element::name)
                .filter(name -> !name.isEmpty())
                .toList();
        AstahLabel label = missing(transition.name(), String.join(", ", triggers), guard, String.join("; ", effects));
        return new Arc(
                AstahChart.place(transition),
                source,
                target,
                label.trigger().isEmpty() ? triggers : List.of(label.trigger()),
                Condition.guard(label.guard().isEmpty() ? guard : label.guard()),
                label.effect().isEmpty() ? effects : List.of(label.effect()),
                kind);
    }

    /** The parts of the transition's label that its elements lack; nothing if the label names another trigger. */
    private static AstahLabel missing(String text, String trigger, String guard, String effect) {
        AstahLabel label = AstahLabel.parse(text);
        if (!trigger.isEmpty() && !label.trigger().isEmpty() && !label.trigger().equals(trigger)) {
            return new AstahLabel("", "", "");
        }
        return new AstahLabel(
                trigger.isEmpty() ? label.trigger() : "",
                guard.isEmpty() ? label.guard() : "",
                effect.isEmpty() ? label.effect() : "");
    }

    private String guard(Transition transition) {
        List<AstahXml.Guard> guards = transition.guards.stream()
                .flatMap(role -> role.guards.stream())
                .filter(guard -> !guard.name().isEmpty())
                .toList();
        guards.stream()
                .skip(1)
                .forEach(further -> problems.add(
                        further.line,
                        "second guard " + further.label() + " of transition " + transition.label()
                                + "; join them by 'and' in one"));
        return guards.isEmpty() ? "" : guards.get(0).name();
    }

    /** The event's name; if there is none, reports a problem and returns an empty text. */
    String eventName(Event event, Element owner) {
        String name = event.idref().isEmpty() ? event.name() : file.eventNames().get(event.idref());
        String whose = "the trigger of " + owner.word() + " " + owner.label();
        if (name == null) {
            problems.add(
                    event.line,
                    whose + " refers to the unknown event id " + Problems.quote(event.idref())
                            + "; export the model again, or correct the id");
            return "";
        }
        if (name.isEmpty()) {
            problems.add(event.line, whose + " has no name; give it one");
        }
        return name;
    }
}
