package org.evoloop.statechart;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;

/** Checks the rules that a statechart must obey before it can be flattened, independent of the order of events. */
final class ChartRules {
    private static final String BRANCHES = "give each its own guard, one of them may be [else]";

    private final Net net;
    private final List<Problem> problems;

    private ChartRules(Net net, List<Problem> problems) {
        this.net = net;
        this.problems = problems;
    }

    /** @param problems receives the violations */
    static void check(Net net, List<Problem> problems) {
        new ChartRules(net, problems).check();
    }

    private void check() {
        if (net.tops().isEmpty()) {
            refuse(net.chart().place(), "the machine has no states", "draw an initial pseudostate and states");
        }
        for (Zone top : net.tops()) {
            if (top.initial == null) {
                refuse(
                        top.region.place(),
                        "no initial pseudostate in " + top,
                        "draw one with a transition to the first state");
            }
        }
        Set<String> timeTriggers = new HashSet<>();
        for (Node node : net.nodes()) {
            if (node.vertex instanceof ChartState state) {
                state(node, state);
            } else if (node.isFinal()) {
                refuseOutgoing(node);
            } else {
                pseudostate(node);
            }
            if (!node.hasOnlySimple() || !net.timeTriggers().isEmpty()) {
                for (Link link : node.outgoing) {
                    link(link, timeTriggers);
                }
            }
        }
        net.nodes().forEach(node -> node.zones.forEach(this::names));
        net.tops().forEach(this::names);
        keywords();
    }

    /** Refuses the keywords that have not been understood, and those of anything but states and events. */
    private void keywords() {
        for (Node node : net.nodes()) {
            node.zones.forEach(this::keyword);
            keyword(node.vertex.place(), node.toString(), node.vertex.name(), node.isState());
            node.deferred().forEach(event -> keyword(node.vertex.place(), event));
            for (Link link : node.outgoing) {
                List<String> triggers = link.arc.triggers();
                for (int i = 0; i < triggers.size(); i++) {
                    keyword(link.arc.place(), triggers.get(i));
                }
            }
        }
        net.tops().forEach(this::keyword);
        net.chart().events().forEach(event -> keyword(net.chart().place(), event));
    }

    private void keyword(Zone zone) {
        keyword(zone.region.place(), zone.toString(), zone.region.name(), false);
    }

    private void keyword(Place place, String what, String name, boolean state) {
        if (Keywords.isInName(name)) {
            problems.add(
                    state
                            ? Keywords.problem(place, what, name, true)
                            : new Problem(place, what + " has a keyword", "draw it at a state"));
        }
    }

    private void keyword(Place place, String event) {
        if (Keywords.isBeforeEvent(event)) {
            problems.add(Keywords.problem(place, "event '" + event + "'", event, false));
        }
    }

    private void names(Zone zone) {
        Map<String, Node> byName = new HashMap<>(2 * zone.nodes.size());
        for (Node node : zone.nodes) {
            Node namesake = node.isState() ? byName.putIfAbsent(node.vertex.name(), node) : null;
            if (namesake != null && !node.vertex.name().isEmpty()) {
                refuse(node, node + " has the name of the state in " + namesake.vertex.place(), "rename one of them");
            }
        }
    }

    private void state(Node node, ChartState state) {
        if (state.name().isBlank()) {
            refuse(node, "state without a name", "give it one");
        }
        for (String event : state.deferred()) {
            if (net.isTime(event)) {
                refuse(node, node + " defers the time trigger '" + event + "'", "let the state's timer wait longer");
            }
        }
        if (node.hasRivals()) {
            rivals(node);
        }
    }

    private void rivals(Node node) {
        Map<String, Link> always = new HashMap<>();
        for (Link link : node.outgoing) {
            if (link.rank() == 0 && !link.isGuarded()) {
                continue;
            }
            for (String trigger : link.arc.triggers().isEmpty() ? List.of("") : link.arc.triggers()) {
                Link rival = always.putIfAbsent(trigger + '\n' + link.arc.guard(), link);
                if (rival != null && rival != link && !(link.isGuarded() && depends(rival, link))) {
                    refuse(
                            link.arc.place(),
                            "two transitions leave " + node + (trigger.isEmpty() ? "" : " on event " + trigger) + ": "
                                    + rival + " and " + link,
                            "remove one of them or give it another event or guard");
                }
            }
        }
    }

    /** Whether two transitions with the same guard can still be told apart by the branches after them. */
    private static boolean depends(Link one, Link other) {
        return !one.target.isTarget() || !other.target.isTarget();
    }

    private void pseudostate(Node node) {
        if (node.is(Kind.INITIAL)) {
            refuseIncoming(node);
            requireOne(node);
        } else if (node.is(Kind.JUNCTION) || node.is(Kind.CHOICE)) {
            branches(node);
        } else if (node.is(Kind.FORK)) {
            fork(node);
        } else if (node.is(Kind.JOIN)) {
            join(node);
        } else if (node.isHistory()) {
            if (node.outgoing.size() > 1) {
                refuse(node, node + " has " + node.outgoing.size() + " default transitions", "keep one");
            }
        } else if (node.is(Kind.TERMINATE)) {
            refuseOutgoing(node);
        } else if (node.border == null) {
            refuse(node, node + " stands on no state", "draw it on the border of a composite state");
        } else {
            // An entry point without a transition enters its state by default.
            if (node.is(Kind.EXIT_POINT)) {
                requireOne(node);
            } else if (node.isSplit()) {
                fork(node);
                node.outgoing.stream()
                        .filter(link -> !node.border.holds(link.target))
                        .forEach(link -> refuse(link.arc.place(), link + " leads out", "end it inside the state"));
            }
            node.outgoing.forEach(link -> refuseGuard(link, "draw a choice behind it"));
        }
    }

    private void branches(Node node) {
        if (node.outgoing.isEmpty()) {
            refuse(node, "no transition leaves the " + node, "draw one to a state");
        }
        Map<String, Link> byGuard = new HashMap<>();
        for (Link link : node.outgoing) {
            Link rival = byGuard.putIfAbsent(link.arc.guard(), link);
            if (rival != null) {
                refuse(link.arc.place(), "two branches leave the " + node + ": " + rival + " and " + link, BRANCHES);
            }
        }
    }

    private void fork(Node node) {
        if (node.outgoing.isEmpty()) {
            refuse(node, "no transition leaves the " + node, "draw one into each region");
        }
        Map<Zone, Link> byZone = new HashMap<>();
        for (Link link : node.outgoing) {
            refuseGuard(link, "guard the transition to the fork");
            if (!link.target.isTarget() || link.target.is(Kind.TERMINATE)) {
                refuse(link.arc.place(), link + " does not end in a state", "end it in a state of a region");
            }
            Link rival = byZone.putIfAbsent(link.target.zone, link);
            if (rival != null) {
                refuse(link.arc.place(), "two branches of the " + node + " end in one region", "keep one");
            }
        }
    }

    private void join(Node node) {
        requireOne(node);
        node.outgoing.forEach(link -> refuseGuard(link, "guard the transitions to the join"));
        for (Link link : node.incoming) {
            if (!link.source.isState()) {
                refuse(link.arc.place(), link + " does not begin in a state", "begin it in a state of a region");
            }
            if (!Set.copyOf(link.arc.triggers())
                    .equals(Set.copyOf(node.incoming.get(0).arc.triggers()))) {
                refuse(
                        link.arc.place(),
                        "the transitions to the " + node + " have different triggers: " + node.incoming.get(0) + " and "
                                + link,
                        "give all of them the same, or none");
            }
        }
    }

    private void link(Link link, Set<String> timeTriggers) {
        Place place = link.arc.place();
        if (!link.source.isState() && !link.arc.triggers().isEmpty()) {
            refuse(place, link + " has a trigger but does not leave a state", "move the trigger to the one before it");
        }
        if (link.isInternal() && link.arc.triggers().isEmpty()) {
            refuse(place, "internal " + link + " has no trigger", "give it an event");
        }
        if (Zone.common(link.source.zone, link.target.zone) == null) {
            refuse(place, link + " leads from one region of the machine into another", "end it in its own region");
        }
        if (link.target.is(Kind.EXIT_POINT) && link.target.border != null && !link.target.border.holds(link.source)) {
            refuse(place, link + " comes from outside", "end it at the state or at an entry point");
        }
        for (String trigger : net.timeTriggers().isEmpty() ? List.<String>of() : link.arc.triggers()) {
            try {
                if (net.isTime(trigger) && timeTriggers.add(trigger)) {
                    new Event(trigger).timeTrigger();
                }
            } catch (ModelException malformed) {
                refuse(place, String.valueOf(malformed.getMessage()), "correct it on the " + link);
            }
        }
    }

    private void requireOne(Node node) {
        if (node.outgoing.isEmpty()) {
            refuse(node, "no transition leaves the " + node, "draw one to a state");
        }
        node.outgoing.stream()
                .skip(1)
                .forEach(link -> refuse(
                        link.arc.place(),
                        "second " + link + " leaves the " + node,
                        "keep one, or draw a choice behind it"));
    }

    private void refuseGuard(Link link, String remedy) {
        if (!link.arc.guard().isEmpty()) {
            refuse(link.arc.place(), link + " must have no guard", remedy);
        }
    }

    private void refuseOutgoing(Node node) {
        node.outgoing.forEach(link -> refuse(link.arc.place(), link + " leaves a " + node.word(), "remove it"));
    }

    private void refuseIncoming(Node node) {
        node.incoming.forEach(
                link -> refuse(link.arc.place(), link + " ends in an initial pseudostate", "end it in a state"));
    }

    private void refuse(Node node, String message, String remedy) {
        refuse(node.vertex.place(), message, remedy);
    }

    private void refuse(Place place, String message, String remedy) {
        problems.add(new Problem(place, message, remedy));
    }
}
