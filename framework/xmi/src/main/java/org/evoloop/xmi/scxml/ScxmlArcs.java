package org.evoloop.xmi.scxml;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.EventKeywords;
import org.evoloop.statechart.Place;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.XmlNode;
import org.jspecify.annotations.Nullable;

/**
 * Turns the transitions of a document into arcs.
 *
 * <p>A transition without an event is taken as soon as its condition holds. If one of the state's transitions without
 * an event has no condition, it becomes an arc without a trigger; otherwise one with a change trigger {@code when
 * CONDITION}, as in UML.
 */
final class ScxmlArcs {
    private final ScxmlTree tree;
    private final ScxmlEvents events;
    private final Problems problems;
    private final Map<String, List<Arc>> arcs = new HashMap<>();
    private final Map<String, List<Vertex>> forks = new HashMap<>();
    private final Map<ScxmlVertex, List<Arc>> internal = new HashMap<>();
    /**
     * For each event that a transition always takes, alone or with a condition, the last state that has such a
     * transition.
     */
    private final Map<Object, ScxmlVertex> taken = new HashMap<>();
    /** The number of transitions read; see {@link Arc#order}. */
    private int order;

    ScxmlArcs(ScxmlTree tree, Problems problems) {
        this.tree = tree;
        this.events = new ScxmlEvents(tree);
        this.problems = problems;
    }

    /** The name of the region that contains this vertex. Each child of a parallel state has a separate region. */
    String region(ScxmlVertex vertex) {
        ScxmlVertex parent = vertex.parent();
        return ScxmlTree.isParallel(parent) ? "around " + vertex.key() : regionIn(parent);
    }

    /** The name of the region for the contents of a state, or of the root for null. */
    String regionIn(@Nullable ScxmlVertex container) {
        return container == null ? "root" : "in " + container.key();
    }

    List<Arc> in(String region) {
        return arcs.getOrDefault(region, List.of());
    }

    List<Vertex> forksIn(String region) {
        return forks.getOrDefault(region, List.of());
    }

    List<Arc> internal(ScxmlVertex state) {
        return internal.getOrDefault(state, List.of());
    }

    /** Reads the transitions of all states in a container, at any depth. */
    void readAll(@Nullable ScxmlVertex container) {
        for (ScxmlVertex vertex : tree.vertices(container)) {
            if (vertex.isHistory() && ScxmlTree.isParallel(container)) {
                historyOfRegions(vertex, requireNonNull(container));
            } else if (vertex.isHistory()) {
                vertex.transitions()
                        .forEach(transition ->
                                unconditional(transition, vertex.key(), region(vertex), ScxmlActions.in(transition)));
            } else {
                Supplier<String> label = () -> "transition of " + vertex.label();
                vertex.transitions().forEach(transition -> read(transition, vertex, label));
            }
            readAll(vertex);
        }
    }

    /** The key of the pseudostate that represents a parallel state's history in the region of one of its children. */
    String historyKey(ScxmlVertex history, ScxmlVertex child) {
        return history.key() + "#" + child.key();
    }

    /**
     * Replaces a parallel state's history by a fork to one history per region. Its default transition is split in the
     * same way.
     */
    private void historyOfRegions(ScxmlVertex history, ScxmlVertex parallel) {
        Place place = history.place();
        String region = region(parallel);
        forks.computeIfAbsent(region, any -> new ArrayList<>())
                .add(new Pseudostate(history.key(), "", place, Kind.FORK));
        List<XmlNode> transitions = history.transitions();
        Supplier<String> label = () -> "default of " + history.label();
        List<ScxmlVertex> defaults = transitions.stream()
                .flatMap(transition -> tree.targets(ids(transition), transition.line(), label).stream())
                .toList();
        List<String> effects = transitions.stream()
                .flatMap(transition -> ScxmlActions.in(transition).stream())
                .toList();
        for (ScxmlVertex child : parallel.inner()) {
            if (child.isHistory()) {
                continue;
            }
            String key = historyKey(history, child);
            add(region, new Arc(place, history.key(), key, List.of(), "", List.of(), Arc.Kind.EXTERNAL));
            List<ScxmlVertex> inside = defaults.stream()
                    .filter(end -> end == child || end.isInside(child))
                    .toList();
            // A child of which the default says nothing is entered as the parallel state enters it.
            if (!inside.isEmpty() || defaults.isEmpty()) {
                String target = inside.isEmpty() ? child.key() : target(inside, label, place);
                add(region(child), new Arc(place, key, target, List.of(), "", effects, Arc.Kind.EXTERNAL));
                effects = List.of();
            }
        }
    }

    /** Reads the default transition of a history or the transition to an initial state. */
    void unconditional(XmlNode transition, String source, String region, List<String> effects) {
        Supplier<String> label = () -> "transition in line " + transition.line();
        if (!transition.attribute("event").isEmpty()) {
            problems.add(transition.line(), label.get() + " of an initial or history has an event; remove it");
        }
        String condition = transition.attribute("cond").strip();
        List<ScxmlVertex> targets = tree.targets(ids(transition), transition.line(), label);
        lead(source, region, targets, condition, label, effects, new Place("", transition.line()));
    }

    /** Adds an arc that is always taken. */
    void lead(
            String source,
            String region,
            List<ScxmlVertex> targets,
            String condition,
            Supplier<String> label,
            List<String> effects,
            Place place) {
        if (targets.isEmpty()) {
            problems.add(place.line(), label.get() + " has no target; give it one");
            return;
        }
        add(
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

    /** The ids of the targets; drafts of SCXML had elements for them. */
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

    /** @param label computed only when needed, since there may be a hundred thousand transitions */
    private void read(XmlNode transition, ScxmlVertex state, Supplier<String> label) {
        String ids = ids(transition);
        List<ScxmlVertex> targets = tree.targets(ids, transition.line(), label);
        if (targets.isEmpty() && !ids.isEmpty()) {
            return;
        }
        String condition = transition.attribute("cond").strip();
        String event = transition.attribute("event");
        if (!event.isBlank()) {
            events.neverDone(event)
                    .forEach(inner -> problems.note(
                            transition.line(),
                            label.get() + " waits for " + inner.label()
                                    + " to be done, which never happens; give it a final state, or each of its children"
                                    + " if it is parallel"));
            events.unknownDone(event)
                    .forEach(
                            id -> problems.note(
                                    transition.line(),
                                    label.get() + " waits for " + Problems.quote(id)
                                            + " to be done, but no state has this id; correct it, unless the event comes from outside"));
            List<String> triggers = free(events.matched(event), condition, state);
            if (triggers.isEmpty()) {
                never(transition, label);
            } else {
                arc(transition, state, targets, triggers, condition, label);
            }
        } else if (!alwaysLeaves(state)) {
            arc(transition, state, targets, List.of("when " + condition), "", label);
        } else if (free(List.of(""), condition, state).isEmpty()) {
            never(transition, label);
        } else {
            arc(transition, state, targets, List.of(), condition, label);
        }
    }

    /**
     * The causes that no earlier transition of the state always takes. If several transitions are enabled, SCXML takes
     * the first.
     */
    private List<String> free(List<String> causes, String condition, ScxmlVertex state) {
        if (causes.isEmpty()) {
            return causes;
        }
        boolean all = true;
        // No iterators: with a hundred thousand transitions they would be most of the garbage.
        for (int i = 0; i < causes.size(); i++) {
            all &= isFree(causes.get(i), condition, state);
        }
        List<String> free = all
                ? causes
                : causes.stream()
                        .filter(cause -> isFree(cause, condition, state))
                        .toList();
        for (int i = 0; i < causes.size(); i++) {
            taken.put(condition.isEmpty() ? causes.get(i) : List.of(causes.get(i), condition), state);
        }
        return free;
    }

    private boolean isFree(Object cause, String condition, ScxmlVertex state) {
        return taken.get(cause) != state && (condition.isEmpty() || taken.get(List.of(cause, condition)) != state);
    }

    private void never(XmlNode transition, Supplier<String> label) {
        problems.note(
                transition.line(),
                label.get() + " is never taken, since earlier ones always take its events, and is ignored; remove it");
    }

    private static boolean alwaysLeaves(ScxmlVertex state) {
        return state.transitions().stream()
                .anyMatch(transition -> transition.attribute("event").isBlank()
                        && transition.attribute("cond").isBlank());
    }

    private void arc(
            XmlNode transition,
            ScxmlVertex state,
            List<ScxmlVertex> targets,
            List<String> names,
            String guard,
            Supplier<String> label) {
        String keywords = EventKeywords.before(ScxmlOwn.isSpontaneous(transition), ScxmlOwn.isUrgent(transition));
        List<String> triggers = keywords.isEmpty()
                ? names
                : names.stream().map(name -> keywords + name).toList();
        Place place = new Place("", transition.line());
        String key = state.key();
        List<String> effects = ScxmlActions.in(transition);
        order++;
        if (targets.isEmpty()) {
            internal.computeIfAbsent(state, any -> new ArrayList<>())
                    .add(new Arc(place, key, key, triggers, guard, effects, Arc.Kind.INTERNAL, order));
            return;
        }
        Arc.Kind kind = isLocal(transition, state, targets) ? Arc.Kind.LOCAL : Arc.Kind.EXTERNAL;
        add(region(state), new Arc(place, key, target(targets, label, place), triggers, guard, effects, kind, order));
    }

    private static boolean isLocal(XmlNode transition, ScxmlVertex state, List<ScxmlVertex> targets) {
        return transition.attribute("type").equals("internal")
                && state.isState()
                && state.isComposite()
                && targets.stream().allMatch(target -> target.isHistory() || target.isInside(state));
    }

    /** The key of the only target, or of a fork to all of them. */
    private String target(List<ScxmlVertex> targets, Supplier<String> label, Place place) {
        if (targets.size() == 1) {
            return targets.get(0).key();
        }
        ScxmlVertex common = ScxmlTree.commonContainer(targets);
        String fork = tree.madeUpKey();
        if (common == null || !ScxmlTree.isParallel(common)) {
            problems.add(
                    place.line(),
                    label.get() + " has targets that do not stand in different children of one parallel state");
            return fork;
        }
        String region = region(common);
        forks.computeIfAbsent(region, any -> new ArrayList<>()).add(new Pseudostate(fork, "", place, Kind.FORK));
        for (ScxmlVertex target : targets) {
            add(region, new Arc(place, fork, target.key(), List.of(), "", List.of(), Arc.Kind.EXTERNAL));
        }
        return fork;
    }

    private void add(String region, Arc arc) {
        arcs.computeIfAbsent(region, any -> new ArrayList<>()).add(arc);
    }
}
