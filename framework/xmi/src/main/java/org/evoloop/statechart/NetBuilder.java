package org.evoloop.statechart;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.jspecify.annotations.Nullable;

/** Connects the vertices of a statechart. {@link ChartRules} later checks whether the connections are allowed. */
final class NetBuilder {
    /** Deeper than anyone can read, and shallow enough for the recursive calls that enter and leave states. */
    private static final int MAX_DEPTH = 300;

    private final Statechart chart;
    private final List<Problem> problems;
    private final List<Zone> tops = new ArrayList<>();
    private final List<Node> nodes = new ArrayList<>();
    private final Map<String, Node> byKey = new HashMap<>();
    private final List<Arc> arcs = new ArrayList<>();
    private final Set<String> spontaneous = new LinkedHashSet<>();
    private final Set<String> urgent = new LinkedHashSet<>();
    private int zones;

    private NetBuilder(Statechart chart, List<Problem> problems) {
        this.chart = chart;
        this.problems = problems;
    }

    /** A work item: a region of {@code owner}, or a vertex of {@code zone}. Recursion could overflow the stack. */
    private record Work(
            @Nullable Region region,
            @Nullable Node owner,
            @Nullable Vertex vertex,
            @Nullable Zone zone) {}

    /** @param problems receives what cannot be connected */
    static Net build(Statechart chart, List<Problem> problems) {
        return new NetBuilder(chart, problems).build();
    }

    private Net build() {
        Deque<Work> left = new ArrayDeque<>();
        pushRegions(chart.regions(), null, left);
        while (!left.isEmpty()) {
            Work work = left.pop();
            if (work.region() != null) {
                zone(work.region(), work.owner(), left);
            } else if (work.vertex() != null && work.zone() != null) {
                vertex(work.vertex(), work.zone(), left);
            }
        }
        connect();
        Map<String, Node> named = new HashMap<>();
        boolean scxml = chart.semantics() == Statechart.Semantics.SCXML;
        Comparator<Link> order = Comparator.comparingInt(scxml ? link -> link.arc.order() : Link::rank);
        nodes.forEach(node -> node.arrange(order, named));
        Set<String> raised = new HashSet<>();
        if (scxml) {
            nodes.stream()
                    .filter(Node::isState)
                    .map(Node::doneEvent)
                    .filter(named::containsKey)
                    .forEach(raised::add);
        }
        Set<String> timeTriggers = new HashSet<>(named.keySet());
        nodes.forEach(node -> timeTriggers.addAll(node.deferred()));
        timeTriggers.removeIf(name -> !isTime(name));
        boolean calm = timeTriggers.isEmpty()
                && nodes.stream().allMatch(node -> node.activities().isEmpty());
        return new Net(chart, tops, nodes, named.keySet(), timeTriggers, spontaneous, urgent, raised, calm);
    }

    static boolean isTime(String trigger) {
        try {
            return new Event(trigger).timeTrigger().isPresent();
        } catch (ModelException malformed) {
            // ChartRules reports what is wrong with it.
            return true;
        }
    }

    private static void pushRegions(List<Region> regions, @Nullable Node owner, Deque<Work> left) {
        for (int i = regions.size() - 1; i >= 0; i--) {
            left.push(new Work(regions.get(i), owner, null, null));
        }
    }

    private void zone(Region region, @Nullable Node owner, Deque<Work> left) {
        arcs.addAll(region.arcs());
        if (region.vertices().isEmpty()) {
            return;
        }
        boolean ofParallel = chart.semantics() == Statechart.Semantics.SCXML
                && !region.name().isEmpty();
        Zone zone = new Zone(region, owner, zones++, ofParallel);
        if (zone.depth > MAX_DEPTH) {
            problems.add(new Problem(
                    region.place(), "states are nested deeper than " + MAX_DEPTH, "draw a machine of fewer levels"));
            // What is left could not be connected.
            left.clear();
            arcs.clear();
            return;
        }
        if (owner == null) {
            tops.add(zone);
        } else {
            owner.add(zone);
        }
        for (int i = region.vertices().size() - 1; i >= 0; i--) {
            left.push(new Work(null, null, region.vertices().get(i), zone));
        }
    }

    private void vertex(Vertex vertex, Zone zone, Deque<Work> left) {
        boolean point = vertex instanceof Pseudostate pseudostate
                && (pseudostate.kind() == Kind.ENTRY_POINT || pseudostate.kind() == Kind.EXIT_POINT);
        Node node = point && zone.owner != null
                ? add(new Node(vertex, nodes.size(), zone.owner.zone, zone.owner))
                : add(new Node(vertex, nodes.size(), zone, null));
        zone.nodes.add(node);
        zone.hasHistory |= node.isHistory();
        if (node.is(Kind.INITIAL)) {
            if (zone.initial == null) {
                zone.initial = node;
            } else {
                problems.add(new Problem(
                        vertex.place(),
                        "second " + node + " of " + zone + ", the first is in " + zone.initial.vertex.place(),
                        "keep one"));
            }
        }
        if (vertex instanceof ChartState state) {
            for (Pseudostate connection : state.connections()) {
                add(new Node(connection, nodes.size(), zone, node));
            }
            arcs.addAll(state.internal());
            pushRegions(state.regions(), node, left);
        }
    }

    private Node add(Node node) {
        nodes.add(node);
        Node earlier = byKey.putIfAbsent(node.vertex.key(), node);
        if (earlier != null) {
            problems.add(new Problem(
                    node.vertex.place(),
                    node + " has the same key as " + earlier + " in " + earlier.vertex.place(),
                    "give each its own"));
        }
        return node;
    }

    private void connect() {
        Node source = null;
        for (Arc arc : arcs) {
            // The transitions of a vertex are usually drawn one after the other.
            if (source == null || !source.vertex.key().equals(arc.source())) {
                source = byKey.get(arc.source());
            }
            connect(arc, source, byKey.get(arc.target()));
        }
    }

    private void connect(Arc arc, @Nullable Node source, @Nullable Node target) {
        if (source == null || target == null) {
            problems.add(new Problem(
                    arc.place(),
                    "a transition leads " + (source == null ? "from" : "to") + " '"
                            + (source == null ? arc.source() : arc.target()) + "', which is no vertex of the machine",
                    "draw it from state to state"));
            return;
        }
        Link link = new Link(arc, source, target);
        source.addOutgoing(link);
        spontaneous.addAll(arc.spontaneous());
        urgent.addAll(arc.urgent());
        if (target.isPseudostate()) {
            target.addIncoming(link);
        }
    }
}
