package org.evoloop.statechart;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.statemachine.Transition;

/** Names what an {@link Explorer} found. */
final class FlatMachine {
    private final Net net;
    private final Map<Snapshot, List<Explorer.Move>> moves;
    private final Map<Snapshot, Snapshot> representatives;
    private final FlatNames naming;
    private final Map<Snapshot, State> states = new LinkedHashMap<>();
    private final Map<Snapshot, Set<Owned>> goingOn = new HashMap<>();
    private final Map<Event, Event> events = new HashMap<>();
    /** Time triggers and activities that several active states have at once. */
    private final Set<String> ambiguous = new HashSet<>();

    FlatMachine(Net net, Map<Snapshot, List<Explorer.Move>> moves) {
        this.net = net;
        this.moves = moves;
        this.representatives = Histories.merge(moves);
        List<Snapshot> ordered = moves.keySet().stream()
                .map(this::representative)
                .distinct()
                .sorted()
                .toList();
        this.naming = new FlatNames(net, ordered);
        naming.all().forEach((state, name) -> states.put(state, new State(name)));
        ordered.forEach(this::findAmbiguous);
    }

    /** What goes on while a state as drawn is active. */
    private record Owned(Node owner, String name, boolean activity) {}

    /** The innermost vertices of each flat state. */
    Map<State, List<Vertex>> leaves() {
        Map<State, List<Vertex>> leaves = new LinkedHashMap<>();
        states.forEach((state, flat) -> {
            List<Vertex> vertices = new ArrayList<>();
            for (int leaf : state.leaves()) {
                vertices.add(net.node(leaf).vertex);
            }
            leaves.put(flat, List.copyOf(vertices));
        });
        return leaves;
    }

    StateMachine machine(Outcome start) {
        StateMachineBuilder builder = StateMachine.named(net.chart().name());
        states.forEach((state, flat) -> {
            List<String> activities = new ArrayList<>();
            for (Owned owned : goingOn(state)) {
                if (owned.activity()) {
                    activities.add(name(owned));
                }
            }
            builder.activities(flat.name(), activities);
        });
        builder.initial(flat(start.target()).name()).initialEffects(start.effects());
        states.forEach((state, flat) -> {
            for (Explorer.Move move : moves.getOrDefault(state, List.of())) {
                builder.transition(transition(state, flat, move), "");
            }
        });
        net.chart().events().stream().filter(event -> !event.isBlank()).forEach(builder::event);
        return builder.build();
    }

    private Transition transition(Snapshot source, State flat, Explorer.Move move) {
        Outcome outcome = move.outcome();
        State target = flat(outcome.target());
        boolean internal = outcome.still() && target.equals(flat);
        Event event = events.computeIfAbsent(new Event(event(move.cause()), move.guards()), known -> known);
        return new Transition(
                flat, event, target, outcome.effects(), internal, internal ? Set.of() : keeps(source, outcome));
    }

    private String event(Cause cause) {
        Node owner = cause.owner();
        if (owner == null) {
            return cause.name();
        }
        return cause.kind() == Cause.Kind.TIME
                ? name(new Owned(owner, cause.name(), false))
                : "completion(" + naming.of(owner) + ")";
    }

    private Set<String> keeps(Snapshot source, Outcome outcome) {
        Set<Owned> before = goingOn(source);
        if (before.isEmpty()) {
            return Set.of();
        }
        Set<Owned> after = goingOn(outcome.target());
        Set<String> keeps = new LinkedHashSet<>();
        for (Owned owned : before) {
            if (!outcome.left().contains(owned.owner()) && after.contains(owned)) {
                keeps.add(name(owned));
            }
        }
        return keeps;
    }

    private Snapshot representative(Snapshot state) {
        return representatives.getOrDefault(state, state);
    }

    private State flat(Snapshot state) {
        return requireNonNull(states.get(representative(state)));
    }

    private String name(Owned owned) {
        return ambiguous.contains(owned.name()) ? owned.name() + " in " + naming.of(owned.owner()) : owned.name();
    }

    private void findAmbiguous(Snapshot state) {
        Map<String, Owned> byName = new HashMap<>();
        for (Owned owned : goingOn(state)) {
            if (byName.put(owned.name(), owned) != null) {
                ambiguous.add(owned.name());
            }
        }
    }

    /** The time triggers and activities of the active states, outer ones first. */
    private Set<Owned> goingOn(Snapshot state) {
        return goingOn.computeIfAbsent(state, this::findGoingOn);
    }

    private Set<Owned> findGoingOn(Snapshot state) {
        Set<Owned> all = new LinkedHashSet<>();
        for (Node node : active(state)) {
            for (String trigger : node.triggers()) {
                if (net.isTime(trigger)) {
                    all.add(new Owned(node, trigger, false));
                }
            }
            node.activities().forEach(activity -> all.add(new Owned(node, activity, true)));
        }
        return all;
    }

    private List<Node> active(Snapshot state) {
        Set<Node> active = new LinkedHashSet<>();
        for (int leaf : state.leaves()) {
            if (net.node(leaf).is(Vertex.Kind.TERMINATE)) {
                return List.of();
            }
            List<Node> chain = new ArrayList<>();
            for (Node node = net.node(leaf); node != null; node = node.zone.owner) {
                chain.add(0, node);
            }
            active.addAll(chain);
        }
        return List.copyOf(active);
    }
}
