package org.evoloop.xmi.scxml;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.Place;
import org.evoloop.statechart.Spontaneous;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.FinalState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.XmlNode;
import org.jspecify.annotations.Nullable;

/**
 * Turns the transitions of a document into arcs.
 *
 * <p>A transition without an event is taken as soon as its condition holds: it becomes a completion transition where one
 * of its state's always holds, else a change trigger {@code when CONDITION}, as UML has it. The event
 * {@code done.state.ID} is the completion of that state.
 */
final class ScxmlArcs {
    private static final Set<String> ATTRIBUTES = Set.of("event", "cond", "target", "type");

    private final ScxmlTree tree;
    private final ScxmlEvents events;
    private final Problems problems;
    private final Map<String, List<Arc>> arcs = new HashMap<>();
    /** What an outer state does when an inner one is done comes after what the inner one does itself. */
    private final Map<String, List<Arc>> later = new HashMap<>();

    private final Map<String, List<Vertex>> forks = new HashMap<>();
    private final Map<XmlNode, List<Arc>> internal = new HashMap<>();

    ScxmlArcs(ScxmlTree tree, Problems problems) {
        this.tree = tree;
        this.events = new ScxmlEvents(tree, problems);
        this.problems = problems;
    }

    /** Names the region in which this vertex stands: each child of a parallel state has one of its own. */
    String region(XmlNode vertex) {
        XmlNode parent = tree.parent(vertex);
        return ScxmlTree.isParallel(parent) ? "around " + tree.key(vertex) : regionIn(parent);
    }

    /** Names the region of what stands in a state, or in the root for null. */
    String regionIn(@Nullable XmlNode container) {
        return container == null ? "root" : "in " + tree.key(container);
    }

    List<Arc> in(String region) {
        return Stream.concat(
                        arcs.getOrDefault(region, List.of()).stream(), later.getOrDefault(region, List.of()).stream())
                .toList();
    }

    List<Vertex> forksIn(String region) {
        return forks.getOrDefault(region, List.of());
    }

    List<Arc> internal(XmlNode state) {
        return internal.getOrDefault(state, List.of());
    }

    /** Reads the transitions of all states in a container and further in. */
    void readAll(@Nullable XmlNode container) {
        for (XmlNode vertex : tree.vertices(container)) {
            if (vertex.name().equals("history") && ScxmlTree.isParallel(container)) {
                historyOfRegions(vertex, requireNonNull(container));
            } else if (vertex.name().equals("history")) {
                vertex.children("transition")
                        .forEach(transition -> unconditional(
                                transition, tree.key(vertex), region(vertex), ScxmlActions.in(transition)));
            } else {
                Set<Object> taken = new HashSet<>();
                String label = "transition of " + ScxmlVocabulary.label(vertex);
                vertex.children("transition").forEach(transition -> read(transition, vertex, label, taken));
            }
            readAll(vertex);
        }
    }

    /** The key of what stands for a history of a parallel state in the region of one of its children. */
    String historyKey(XmlNode history, XmlNode child) {
        return tree.key(history) + "#" + tree.key(child);
    }

    /** What leads to a history of a parallel state leads to those of all its regions; so does its default. */
    private void historyOfRegions(XmlNode history, XmlNode parallel) {
        Place place = ScxmlTree.place(history);
        String region = region(parallel);
        forks.computeIfAbsent(region, any -> new ArrayList<>())
                .add(new Pseudostate(tree.key(history), "", place, Kind.FORK));
        List<XmlNode> transitions = history.children("transition");
        String label = "default of " + ScxmlVocabulary.label(history);
        List<XmlNode> defaults = transitions.stream()
                .flatMap(transition -> tree.targets(ids(transition), transition.line(), label).stream())
                .toList();
        List<String> effects = transitions.stream()
                .flatMap(transition -> ScxmlActions.in(transition).stream())
                .toList();
        for (XmlNode child : tree.vertices(parallel)) {
            if (child.name().equals("history")) {
                continue;
            }
            String key = historyKey(history, child);
            add(arcs, region, new Arc(place, tree.key(history), key, List.of(), "", List.of(), Arc.Kind.EXTERNAL));
            XmlNode target = defaults.stream()
                    .filter(end -> tree.isInside(end, child))
                    .findFirst()
                    .orElse(child);
            add(arcs, region(child), new Arc(place, key, tree.key(target), List.of(), "", effects, Arc.Kind.EXTERNAL));
            effects = List.of();
        }
    }

    /** The default of a history or the way to an initial state. */
    void unconditional(XmlNode transition, String source, String region, List<String> effects) {
        String label = "transition in line " + transition.line();
        if (!transition.attribute("event").isEmpty()) {
            problems.add(transition.line(), label + " of an initial or history has an event; remove it");
        }
        String condition = transition.attribute("cond").strip();
        List<XmlNode> targets = tree.targets(ids(transition), transition.line(), label);
        lead(source, region, targets, condition, label, effects, new Place("", transition.line()));
    }

    /** An arc that is always taken. */
    void lead(
            String source,
            String region,
            List<XmlNode> targets,
            String condition,
            String label,
            List<String> effects,
            Place place) {
        if (targets.isEmpty()) {
            problems.add(place.line(), label + " has no target; give it one");
            return;
        }
        add(
                arcs,
                region,
                new Arc(
                        place,
                        source,
                        target(targets, label, place),
                        List.of(),
                        condition,
                        effects,
                        Arc.Kind.EXTERNAL));
    }

    /** Ids of the targets; the drafts of SCXML had elements for them. */
    private static String ids(XmlNode transition) {
        String target = transition.attribute("target");
        return transition.children().isEmpty()
                ? target.strip()
                : Stream.concat(
                                Stream.of(target),
                                transition.children("target").stream().map(element -> element.attribute("next")))
                        .collect(Collectors.joining(" "))
                        .strip();
    }

    /** @param taken what earlier transitions of the state take in any case */
    private void read(XmlNode transition, XmlNode state, String label, Set<Object> taken) {
        for (String attribute : transition.attributeNames()) {
            if (attribute.indexOf(':') < 0 && !ATTRIBUTES.contains(attribute)) {
                problems.add(
                        transition.line(), "attribute " + attribute + " of " + label + " is not supported; remove it");
            }
        }
        String ids = ids(transition);
        List<XmlNode> targets = tree.targets(ids, transition.line(), label);
        if (targets.isEmpty() && !ids.isEmpty()) {
            return;
        }
        String condition = transition.attribute("cond").strip();
        if (!transition.attribute("event").isBlank()) {
            List<XmlNode> done = free(events.doneStates(transition), condition, taken);
            for (XmlNode inner : done) {
                done(transition, state, inner, targets, label);
            }
            List<String> triggers = free(events.triggers(transition, state, label), condition, taken);
            if (!triggers.isEmpty()) {
                arc(transition, state, state, targets, triggers, condition, label);
            } else if (done.isEmpty()) {
                never(transition, label);
            }
        } else if (alwaysLeaves(state)) {
            requireLasting(transition, state, targets, label);
            if (free(List.of(""), condition, taken).isEmpty()) {
                never(transition, label);
            } else {
                arc(transition, state, state, targets, List.of(), condition, label);
            }
        } else {
            arc(transition, state, state, targets, List.of("when " + condition), "", label);
        }
    }

    /** What no earlier transition of the state takes in any case: of several that hold, SCXML takes the first. */
    private static <T> List<T> free(List<T> causes, String condition, Set<Object> taken) {
        if (causes.isEmpty()) {
            return causes;
        }
        List<T> free = taken.isEmpty()
                ? causes
                : causes.stream()
                        .filter(cause -> !taken.contains(cause) && !taken.contains(List.of(cause, condition)))
                        .toList();
        for (T cause : causes) {
            taken.add(condition.isEmpty() ? cause : List.of(cause, condition));
        }
        return free;
    }

    private void never(XmlNode transition, String label) {
        problems.note(
                transition.line(),
                label + " is never taken, since earlier ones always take its events, and is passed over; remove it");
    }

    private void requireLasting(XmlNode transition, XmlNode state, List<XmlNode> targets, String label) {
        if (tree.isComposite(state) || targets.isEmpty()) {
            problems.add(
                    transition.line(),
                    label + " has no event and leads " + (targets.isEmpty() ? "nowhere" : "out of a composite state")
                            + ", so that the state never lasts; give it an event");
        }
    }

    private static boolean alwaysLeaves(XmlNode state) {
        return state.children("transition").stream()
                .anyMatch(transition -> transition.attribute("event").isBlank()
                        && transition.attribute("cond").isBlank());
    }

    /** @param done whose being done triggers the transition */
    private void done(XmlNode transition, XmlNode state, XmlNode done, List<XmlNode> targets, String label) {
        boolean own = done == state;
        boolean outer = tree.isInside(done, state)
                && (isLocal(transition, state, targets)
                        || targets.stream().noneMatch(target -> target == state || tree.isInside(target, state)));
        if (targets.isEmpty() || !(own || outer)) {
            problems.add(
                    transition.line(),
                    label + " waits for " + ScxmlVocabulary.label(done)
                            + " to be done, which is supported only for leaving that state; "
                            + "draw the transition from that state");
            return;
        }
        arc(
                transition,
                state,
                done,
                targets,
                List.of(),
                transition.attribute("cond").strip(),
                label);
    }

    private void arc(
            XmlNode transition,
            XmlNode state,
            XmlNode source,
            List<XmlNode> targets,
            List<String> names,
            String guard,
            String label) {
        List<String> triggers = isSpontaneous(transition)
                ? names.stream().map(Spontaneous::mark).toList()
                : names;
        Place place = new Place("", transition.line());
        String key = tree.key(source);
        List<String> effects = ScxmlActions.in(transition);
        if (targets.isEmpty()) {
            internal.computeIfAbsent(source, any -> new ArrayList<>())
                    .add(new Arc(place, key, key, triggers, guard, effects, Arc.Kind.INTERNAL));
            return;
        }
        boolean local = isLocal(transition, state, targets);
        if (!local) {
            requireSameExits(transition, source, targets, label);
        }
        Arc.Kind kind = local && source == state ? Arc.Kind.LOCAL : Arc.Kind.EXTERNAL;
        add(
                source == state ? arcs : later,
                region(source),
                new Arc(place, key, target(targets, label, place), triggers, guard, effects, kind));
    }

    /** SCXML has no keywords, but lets attributes of other namespaces be. */
    private static boolean isSpontaneous(XmlNode transition) {
        return transition.attributeNames().stream()
                .anyMatch(name -> name.endsWith(":spontaneous")
                        && transition.attribute(name).strip().equals("true"));
    }

    private boolean isLocal(XmlNode transition, XmlNode state, List<XmlNode> targets) {
        return transition.attribute("type").equals("internal")
                && state.name().equals("state")
                && tree.isComposite(state)
                && targets.stream().allMatch(target -> tree.isInside(target, state));
    }

    /** SCXML leaves a parallel state even for a transition within one child of it; UML does not. */
    private void requireSameExits(XmlNode transition, XmlNode source, List<XmlNode> targets, String label) {
        if (tree.parent(source) == null) {
            return;
        }
        List<XmlNode> ends = new ArrayList<>(targets);
        ends.add(source);
        XmlNode common = tree.commonContainer(ends);
        if (common != null
                && ScxmlTree.isParallel(common)
                && ends.stream().map(end -> childOf(common, end)).distinct().count() == 1) {
            problems.add(
                    transition.line(),
                    label + " leaves and enters " + ScxmlVocabulary.label(common)
                            + " as a whole, which is not supported; give it type=\"internal\", or draw it from "
                            + common.attribute("id"));
        }
    }

    private XmlNode childOf(XmlNode container, XmlNode vertex) {
        XmlNode child = vertex;
        XmlNode parent = tree.parent(child);
        while (parent != null && parent != container) {
            child = parent;
            parent = tree.parent(child);
        }
        return child;
    }

    /** The key of the only target, or of a fork to all of them. */
    private String target(List<XmlNode> targets, String label, Place place) {
        if (targets.size() == 1) {
            return tree.key(targets.get(0));
        }
        XmlNode common = tree.commonContainer(targets);
        String fork = tree.madeUpKey();
        if (common == null || !ScxmlTree.isParallel(common)) {
            problems.add(
                    place.line(), label + " has targets that do not stand in different children of one parallel state");
            return fork;
        }
        String region = region(common);
        forks.computeIfAbsent(region, any -> new ArrayList<>()).add(new Pseudostate(fork, "", place, Kind.FORK));
        for (XmlNode target : targets) {
            add(arcs, region, new Arc(place, fork, tree.key(target), List.of(), "", List.of(), Arc.Kind.EXTERNAL));
        }
        return fork;
    }

    /** Lets a state be over as soon as it is entered. */
    void complete(XmlNode state, FinalState end) {
        add(
                arcs,
                region(state),
                new Arc(end.place(), tree.key(state), end.key(), List.of(), "", List.of(), Arc.Kind.EXTERNAL));
    }

    private static void add(Map<String, List<Arc>> to, String region, Arc arc) {
        to.computeIfAbsent(region, any -> new ArrayList<>()).add(arc);
    }
}
