package org.evoloop.statechart;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.NavigableSet;
import java.util.Set;
import java.util.TreeSet;
import org.evoloop.statechart.Vertex.Kind;
import org.jspecify.annotations.Nullable;

/**
 * One macrostep by the algorithm of SCXML 1.0 (appendix D): an external event, then the transitions without an event and
 * those on {@code done.state} events, until nothing is enabled. A microstep takes all its transitions together: first it
 * leaves states, in reverse document order, then it runs the transitions' contents, then it enters states, in document
 * order.
 *
 * <p>A target list is drawn as a fork, and a history of a parallel state as one in each of its regions.
 */
final class ScxmlStep implements RunToCompletion {
    private static final Comparator<Node> DOCUMENT_ORDER = Comparator.comparingInt(node -> node.index);

    /** More events than this wait only in a circle that raises more than it takes. */
    private static final int MAX_RAISED = 1_000;

    private final Net net;
    private final GuardCases guards;
    private final ActiveStates active;
    /** The events that the machine has raised itself. */
    private final Deque<String> raised = new ArrayDeque<>();

    private final List<String> effects = new ArrayList<>();
    private final Set<Node> left = new HashSet<>();
    private final Set<Node> entered = new HashSet<>();
    private boolean ended;

    ScxmlStep(Net net, GuardCases guards) {
        this.net = net;
        this.guards = guards;
        this.active = new ActiveStates(net);
    }

    /**
     * A transition, and the states that it leaves.
     *
     * @param domain the innermost state of one region that contains everything it changes; null for the machine
     */
    private record Take(Link link, @Nullable Node domain, Set<Node> exited) {}

    @Override
    public StepResult start() {
        Zone top = net.tops().get(0);
        Link initial = initial(top);
        run(initial);
        Entry entry = new Entry();
        entry.addDefault(initial, top);
        entry.enter();
        return stable();
    }

    @Override
    public StepResult startIn(Node state) {
        Entry entry = new Entry();
        entry.add(state);
        entry.addAround(state, null);
        entry.enter();
        return stable();
    }

    @Override
    public @Nullable StepResult react(StableConfiguration before, Cause cause) {
        active.load(before);
        List<Take> takes = select(cause.name(), cause.owner());
        if (takes.isEmpty()) {
            return null;
        }
        microstep(takes);
        return stable();
    }

    /** SCXML defers no events. */
    @Override
    public boolean isDeferring() {
        return false;
    }

    private StepResult stable() {
        Set<Object> passed = new HashSet<>();
        while (!ended) {
            List<Take> takes = select("", null);
            if (takes.isEmpty() && raised.isEmpty()) {
                break;
            }
            if (takes.isEmpty()) {
                takes = select(raised.remove(), null);
            }
            if (!takes.isEmpty()) {
                boolean again = !passed.add(List.of(active.snapshot(), List.copyOf(raised), links(takes)));
                if (again || raised.size() > MAX_RAISED) {
                    throw Refused.endless(takes.get(0).link());
                }
                microstep(takes);
            }
        }
        if (ended) {
            inReverseOrder(active.all()).forEach(node -> effects.addAll(node.exit()));
        }
        return new StepResult(active.snapshot(), List.copyOf(effects), left, entered);
    }

    private static List<Link> links(List<Take> takes) {
        return takes.stream().map(Take::link).toList();
    }

    private static List<Node> inReverseOrder(Collection<Node> nodes) {
        return nodes.stream().sorted(DOCUMENT_ORDER.reversed()).toList();
    }

    /**
     * The transitions that are taken together.
     *
     * @param trigger empty for those without an event
     * @param owner the only state whose transitions are asked; null for all
     */
    private List<Take> select(String trigger, @Nullable Node owner) {
        Set<Link> enabled = new LinkedHashSet<>();
        for (int leaf : active.snapshot().leaves()) {
            for (Node state = net.node(leaf); state != null; state = state.zone.owner) {
                Link first = owner == null || owner == state ? first(state, trigger) : null;
                if (first != null) {
                    enabled.add(first);
                    break;
                }
            }
        }
        return withoutRivals(enabled);
    }

    private @Nullable Link first(Node state, String trigger) {
        for (Link link : trigger.isEmpty() ? state.onCompletion() : heard(state, trigger)) {
            if (!link.isGuarded() || guards.holds(link.arc.guard())) {
                return link;
            }
        }
        return null;
    }

    private static List<Link> heard(Node state, String event) {
        return event.startsWith(Node.DONE)
                ? state.outgoing.stream()
                        .filter(link -> link.arc.triggers().stream().anyMatch(trigger -> matches(trigger, event)))
                        .toList()
                : state.on(event);
    }

    private static boolean matches(String descriptor, String event) {
        return descriptor.equals("*") || event.equals(descriptor) || event.startsWith(descriptor + '.');
    }

    /** Of two that leave the same state, the one of the inner state is taken, otherwise the first. */
    private List<Take> withoutRivals(Set<Link> enabled) {
        List<Take> kept = new ArrayList<>();
        for (Link link : enabled) {
            Node domain = domain(link);
            Take take = new Take(link, domain, exited(link, domain));
            List<Take> rivals = kept.stream()
                    .filter(other -> other.exited().stream().anyMatch(take.exited()::contains))
                    .toList();
            if (rivals.stream().allMatch(rival -> isInside(link.source, rival.link().source))) {
                kept.removeAll(rivals);
                kept.add(take);
            }
        }
        return kept;
    }

    private static boolean isInside(Node inner, @Nullable Node outer) {
        return outer == null || (inner != outer && outer.holds(inner));
    }

    private Set<Node> exited(Link link, @Nullable Node domain) {
        Set<Node> exited = new HashSet<>();
        if (!link.isInternal()) {
            active.all().stream().filter(node -> isInside(node, domain)).forEach(exited::add);
        }
        return exited;
    }

    private @Nullable Node domain(Link link) {
        List<Node> ends = effective(link);
        Node source = link.source;
        boolean local = link.arc.kind() == Arc.Kind.LOCAL && !source.zones.isEmpty() && !source.isParallel();
        Node domain = local ? source : source.zone.owner;
        while (domain != null && (domain.isParallel() || !isAround(domain, ends))) {
            domain = domain.zone.owner;
        }
        return domain;
    }

    private static boolean isAround(Node outer, List<Node> ends) {
        return ends.stream().allMatch(end -> isInside(end, outer));
    }

    /** The states to which a transition leads; if one of its targets is a history, those that it remembers. */
    private List<Node> effective(Link link) {
        List<Node> ends = new ArrayList<>();
        targets(link).forEach(target -> ends.addAll(effective(target, new HashSet<>())));
        return ends;
    }

    private List<Node> effective(Node target, Set<Node> passed) {
        if (!target.isHistory()) {
            return List.of(target);
        }
        if (!passed.add(target)) {
            throw new Refused(
                    target.vertex.place(), "the default of " + target + " leads to itself", "end it at a state");
        }
        List<Node> remembered = remembered(target);
        if (remembered != null || saysNothing(target)) {
            return remembered == null ? List.of() : remembered;
        }
        return targets(byDefault(target)).stream()
                .flatMap(next -> effective(next, new HashSet<>(passed)).stream())
                .toList();
    }

    /** Whether the default of a parallel state's history names no state in this child. */
    private static boolean saysNothing(Node history) {
        return history.zone.ofParallel && history.outgoing.isEmpty();
    }

    /** The ends of a transition. */
    private List<Node> targets(Link link) {
        return link.target.is(Kind.FORK)
                ? link.target.outgoing.stream().map(branch -> branch.target).toList()
                : List.of(link.target);
    }

    private static Link initial(Zone zone) {
        if (zone.initial == null || zone.initial.outgoing.isEmpty()) {
            throw new Refused(zone.region.place(), zone + " has no initial state", "give it one");
        }
        return zone.initial.outgoing.get(0);
    }

    /** The default transition of a history; if it has none, that of its state. */
    private static Link byDefault(Node history) {
        return history.outgoing.isEmpty() ? initial(history.zone) : history.outgoing.get(0);
    }

    private @Nullable List<Node> remembered(Node history) {
        List<Node> leaves = active.remembered(history.zone);
        if (leaves == null || history.is(Kind.DEEP_HISTORY)) {
            return leaves;
        }
        Node child = leaves.get(0);
        while (child.zone != history.zone && child.zone.owner != null) {
            child = child.zone.owner;
        }
        return List.of(child);
    }

    private void microstep(List<Take> takes) {
        Set<Node> exited = new HashSet<>();
        takes.forEach(take -> exited.addAll(take.exited()));
        exited.forEach(node -> node.zones.forEach(active::remember));
        for (Node node : inReverseOrder(exited)) {
            effects.addAll(node.exit());
            active.remove(node);
            left.add(node);
        }
        Entry entry = new Entry();
        for (Take take : takes) {
            run(take.link());
            if (!take.link().isInternal()) {
                entry.add(take);
            }
        }
        entry.enter();
    }

    private void run(Link link) {
        effects.addAll(link.arc.effects());
    }

    private boolean isDone(Node state) {
        return state.isParallel()
                ? state.zones.stream().allMatch(zone -> isDone(initial(zone).target))
                : state.zones.stream().anyMatch(zone -> {
                    Node child = active.in(zone);
                    return child != null && child.isFinal();
                });
    }

    /** The states that a microstep enters. */
    private final class Entry {
        private final NavigableSet<Node> states = new TreeSet<>(DOCUMENT_ORDER);
        /** By state, the default transitions taken in it, whose contents run after it is entered. */
        private final Map<Node, Set<Link>> defaults = new HashMap<>();

        private final Set<Node> underWay = new HashSet<>();

        void add(Take take) {
            Link link = take.link();
            if (domain(link) != take.domain()) {
                throw new Refused(
                        link.arc.place(),
                        link + " leaves the state whose history it enters, so that SCXML would enter only a part of it",
                        "end it at a state");
            }
            targets(link).forEach(this::add);
            effective(link).forEach(end -> addAround(end, take.domain()));
        }

        void add(Node target) {
            if (target.isHistory()) {
                List<Node> remembered = remembered(target);
                if (remembered != null) {
                    remembered.forEach(this::add);
                    remembered.forEach(end -> addAround(end, target.zone.owner));
                } else if (!saysNothing(target)) {
                    addDefault(byDefault(target), target.zone);
                }
                return;
            }
            states.add(target);
            for (Zone zone : target.zones) {
                if (zone.ofParallel) {
                    addChild(zone);
                } else {
                    addDefault(initial(zone), zone);
                }
            }
        }

        void addDefault(Link link, Zone zone) {
            if (!underWay.add(link.source)) {
                throw new Refused(link.arc.place(), "the default " + link + " leads to itself", "end it at a state");
            }
            List<Node> targets = targets(link);
            for (Node target : targets) {
                if (Zone.common(zone, target.zone) != zone) {
                    throw new Refused(
                            link.arc.place(),
                            link + " belongs to the default entry of " + zone + " but leads out of it",
                            "end it inside");
                }
            }
            if (zone.owner != null) {
                defaults.computeIfAbsent(zone.owner, any -> new LinkedHashSet<>())
                        .add(link);
            }
            targets.forEach(this::add);
            effective(link).forEach(end -> addAround(end, zone.owner));
            underWay.remove(link.source);
        }

        void addAround(Node inner, @Nullable Node until) {
            for (Node outer = inner.zone.owner; outer != null && outer != until; outer = outer.zone.owner) {
                states.add(outer);
                if (outer.isParallel()) {
                    outer.zones.forEach(this::addChild);
                }
            }
        }

        private void addChild(Zone ofParallel) {
            Node child = initial(ofParallel).target;
            if (states.stream().noneMatch(state -> isInside(state, child))) {
                add(child);
            }
        }

        void enter() {
            for (Node state : states) {
                Node rival = active.in(state.zone);
                if (rival != null) {
                    throw rival == state
                            ? new Refused(
                                    state.vertex.place(),
                                    "a history leads into " + state + " while that is active and not left",
                                    "draw a transition to a state instead")
                            : new Refused(
                                    state.vertex.place(),
                                    "one event leads to " + rival + " and " + state
                                            + ", which cannot be active together",
                                    "end it in states of different children of a parallel state");
                }
                active.add(state);
                entered.add(state);
                effects.addAll(state.entry());
                defaults.getOrDefault(state, Set.of()).forEach(ScxmlStep.this::run);
                if (state.isFinal()) {
                    raiseDone(state.zone.owner);
                }
            }
        }

        private void raiseDone(@Nullable Node parent) {
            ended |= parent == null;
            if (parent != null) {
                raised.add(parent.doneEvent());
                Node outer = parent.zone.owner;
                if (outer != null && outer.isParallel() && isDone(outer)) {
                    raised.add(outer.doneEvent());
                }
            }
        }
    }
}
