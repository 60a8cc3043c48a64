package org.evoloop.statechart;

import static java.util.Objects.requireNonNull;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import org.evoloop.statechart.Vertex.Kind;
import org.jspecify.annotations.Nullable;

/** Leaves and enters the states of a machine along transitions, and collects the behaviors that run. */
final class Body {
    private final Net net;
    private final Function<Link, @Nullable List<Link>> paths;

    private final ActiveStates active;
    private final Deque<Node> completions = new ArrayDeque<>();

    private final List<String> effects = new ArrayList<>();
    private final Set<Node> left = new HashSet<>();
    private final Set<Link> underWay = new HashSet<>();
    private final Set<Node> entered = new HashSet<>();

    /** @param paths returns how a transition continues through pseudostates */
    Body(Net net, Function<Link, @Nullable List<Link>> paths) {
        this.net = net;
        this.active = new ActiveStates(net);
        this.paths = paths;
    }

    ActiveStates active() {
        return active;
    }

    StepResult outcome() {
        return new StepResult(active.snapshot(), List.copyOf(effects), left, entered);
    }

    /** The completed states whose completion transitions have not been tried yet, in order. */
    Deque<Node> completions() {
        return completions;
    }

    /** Ends the do activity of an active state. */
    void finish(Node state) {
        active.finish(state);
        await(state);
    }

    private void await(@Nullable Node state) {
        if (state != null && state.wantsCompletion() && active.isComplete(state) && !completions.contains(state)) {
            completions.add(state);
        }
    }

    /** The outermost active states that a path leaves. */
    Set<Node> exitedBy(List<Link> path) {
        Set<Node> exited = new HashSet<>();
        for (Link link : path) {
            if (link.isInternal()) {
                return exited;
            }
            if (link.isLocalLoop()) {
                link.target.zones.forEach(zone -> exited.add(requireNonNull(active.in(zone))));
                return exited;
            }
            Node node = active.in(domain(link));
            if (node != null) {
                exited.add(node);
            }
            Node border = link.target.border;
            if (link.target.is(Kind.EXIT_POINT) && border != null && active.has(border)) {
                exited.add(border);
            }
        }
        return exited;
    }

    /**
     * The innermost region that contains everything a transition changes. For a join or a fork, all its transitions
     * count, wherever it is drawn.
     */
    private static Zone domain(Link link) {
        Zone domain = requireNonNull(link.domain());
        if (link.target.is(Kind.FORK)) {
            for (Link branch : link.target.outgoing) {
                domain = requireNonNull(Zone.common(domain, branch.target.zone));
            }
        }
        if (link.target.is(Kind.JOIN)) {
            for (Link other : link.target.incoming) {
                domain = requireNonNull(Zone.common(domain, requireNonNull(other.domain())));
            }
        }
        return domain;
    }

    void enterTop() {
        net.tops().forEach(top -> enter(top, Map.of()));
    }

    /** Enters a state and the states around it. */
    void enterFrom(Node state) {
        Zone top = state.zone;
        while (top.owner != null) {
            top = top.owner.zone;
        }
        enter(top, explicit(top, List.of(state)));
        net.tops().forEach(other -> enter(other, Map.of()));
    }

    /** Takes all transitions of a path. */
    void follow(List<Link> path) {
        if (active.isTerminated()) {
            return;
        }
        List<Node> opened = new ArrayList<>();
        for (Link link : path) {
            List<Link> together = link.target.is(Kind.JOIN) ? link.target.incoming : List.of(link);
            if (link.isInternal()) {
                effects.addAll(link.arc.effects());
                return;
            }
            if (link.isLocalLoop()) {
                link.target.zones.forEach(zone -> leave(active.in(zone)));
                effects.addAll(link.arc.effects());
                link.target.zones.forEach(zone -> enter(zone, Map.of()));
                return;
            }
            Zone domain = domain(link);
            leave(active.in(domain));
            together.forEach(one -> effects.addAll(one.arc.effects()));
            arrive(link.target, domain, opened);
        }
        for (Node state : opened) {
            if (active.has(state)) {
                for (Zone zone : state.zones) {
                    enter(zone, Map.of());
                }
            }
        }
    }

    private void arrive(Node node, Zone domain, List<Node> opened) {
        if (node.is(Kind.TERMINATE)) {
            active.terminate(node);
            entered.add(node);
            completions.clear();
        } else if (domain.owner == node) {
            enter(domain, Map.of());
        } else if (node.isTarget()) {
            enter(domain, explicit(domain, List.of(node)));
        } else if (node.is(Kind.FORK)) {
            enter(domain, explicit(domain, branches(node)));
        } else if (node.is(Kind.ENTRY_POINT)) {
            open(domain, node.border, opened);
            if (node.isSplit()) {
                Map<Zone, Node> inside = explicit(domain, branches(node));
                requireNonNull(node.border).zones.forEach(zone -> enter(zone, inside));
            }
        } else if (node.is(Kind.EXIT_POINT)) {
            leave(node.border);
        } else if (!node.is(Kind.JOIN)) {
            open(domain, node.zone.owner, opened);
        }
    }

    /** Takes all transitions of a fork; returns their targets. */
    private List<Node> branches(Node fork) {
        List<Node> targets = new ArrayList<>();
        for (Link link : fork.outgoing) {
            effects.addAll(link.arc.effects());
            targets.add(link.target);
        }
        return targets;
    }

    /** Enters states from the outside in, but not the contents of their regions. */
    private void open(Zone domain, @Nullable Node inner, List<Node> opened) {
        Deque<Node> path = new ArrayDeque<>();
        for (Node state = inner; state != null && !active.has(state); state = state.zone.owner) {
            path.push(state);
            if (state.zone == domain) {
                break;
            }
        }
        path.forEach(state -> {
            begin(state);
            opened.add(state);
        });
    }

    private void leave(@Nullable Node node) {
        if (node == null || !active.has(node)) {
            return;
        }
        for (Zone zone : node.zones) {
            active.remember(zone);
            leave(active.in(zone));
        }
        effects.addAll(node.exit());
        active.remove(node);
        left.add(node);
        completions.remove(node);
    }

    /** For each region between {@code domain} and a target, the vertex on the way to that target. */
    private static Map<Zone, Node> explicit(Zone domain, List<Node> targets) {
        Map<Zone, Node> explicit = new HashMap<>();
        for (Node target : targets) {
            Node node = target;
            while (node.zone != domain && node.zone.owner != null) {
                explicit.put(node.zone, node);
                node = node.zone.owner;
            }
            explicit.put(node.zone, node);
        }
        return explicit;
    }

    private void enter(Zone zone, Map<Zone, Node> explicit) {
        if (active.isTerminated()) {
            return;
        }
        Node wanted = explicit.get(zone);
        Node present = active.in(zone);
        if (wanted == null) {
            if (present == null) {
                enterByDefault(zone);
            }
            return;
        }
        if (wanted.isHistory()) {
            leave(present);
            restore(zone, wanted);
            return;
        }
        if (present != wanted) {
            leave(present);
            begin(wanted);
        }
        for (Zone inner : wanted.zones) {
            enter(inner, explicit);
        }
    }

    private void begin(Node node) {
        active.add(node);
        entered.add(node);
        effects.addAll(node.entry());
        if (node.isFinal()) {
            await(node.zone.owner);
        } else if (node.zones.isEmpty()) {
            await(node);
        }
    }

    private void restore(Zone zone, Node history) {
        List<Node> remembered = active.remembered(zone);
        if (remembered == null) {
            if (history.outgoing.isEmpty()) {
                enterByDefault(zone);
            } else {
                proceed(history.outgoing.get(0), zone);
            }
            return;
        }
        List<Node> targets = new ArrayList<>();
        for (Node vertex : remembered) {
            Node node = vertex;
            while (history.is(Kind.SHALLOW_HISTORY) && node.zone != zone && node.zone.owner != null) {
                node = node.zone.owner;
            }
            targets.add(node);
        }
        enter(zone, explicit(zone, targets));
    }

    private void enterByDefault(Zone zone) {
        if (zone.initial == null) {
            Place place = zone.owner == null ? zone.region.place() : zone.owner.vertex.place();
            throw new Refused(
                    place,
                    zone + " is entered but has no initial pseudostate",
                    "draw one, or end the transition at a state in it");
        }
        proceed(zone.initial.outgoing.get(0), zone);
    }

    /** Takes the default transition of a region, or of a history in it. */
    private void proceed(Link link, Zone zone) {
        List<Link> path = paths.apply(link);
        if (path == null) {
            throw new Refused(
                    link.arc.place(),
                    "the default " + link + " ends where no branch may hold",
                    "draw a branch with the guard [else]");
        }
        for (Link part : path) {
            requireInside(zone, part);
            if (part.target.isSplit()) {
                part.target.outgoing.forEach(branch -> requireInside(zone, branch));
            }
        }
        if (!underWay.add(link)) {
            throw new Refused(link.arc.place(), "the default " + link + " leads to itself", "end it at a state");
        }
        follow(path);
        underWay.remove(link);
    }

    private static void requireInside(Zone zone, Link link) {
        if (Zone.common(zone, link.target.zone) != zone) {
            throw new Refused(
                    link.arc.place(),
                    link + " belongs to the default entry of " + zone + " but leads out of it",
                    "end it inside");
        }
    }
}
