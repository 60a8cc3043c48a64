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
    private final Map<Snapshot, Flat> flats = new LinkedHashMap<>();
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
        naming.all().forEach((snapshot, name) -> flats.put(snapshot, new Flat(new State(name), goingOn(snapshot))));
        flats.values().forEach(this::findAmbiguous);
    }

    private record Flat(State state, Set<Owned> goingOn) {}

    /** What goes on while a state as drawn is active. */
    private record Owned(Node owner, String name, boolean activity) {}

    /** The innermost vertices of each flat state. */
    Map<State, List<Vertex>> leaves() {
        Map<State, List<Vertex>> leaves = new LinkedHashMap<>();
        flats.forEach((snapshot, flat) -> {
            List<Vertex> vertices = new ArrayList<>();
            for (int leaf : snapshot.leaves()) {
                vertices.add(net.node(leaf).vertex);
            }
            leaves.put(flat.state(), List.copyOf(vertices));
        });
        return leaves;
    }

    StateMachine machine(Outcome start) {
        StateMachineBuilder builder = StateMachine.named(net.chart().name());
        for (Flat flat : flats.values()) {
            List<String> activities = new ArrayList<>();
            for (Owned owned : flat.goingOn()) {
                if (owned.activity()) {
                    activities.add(name(owned));
                }
            }
            builder.activities(flat.state().name(), activities);
        }
        builder.initial(flat(start.target()).state().name()).initialEffects(start.effects());
        flats.forEach((snapshot, flat) -> {
            for (Explorer.Move move : moves.getOrDefault(snapshot, List.of())) {
                builder.transition(transition(flat, move), "");
            }
        });
        net.chart().events().stream().filter(event -> !event.isBlank()).forEach(builder::event);
        return builder.build();
    }

    private Transition transition(Flat source, Explorer.Move move) {
        Outcome outcome = move.outcome();
        Flat target = flat(outcome.target());
        boolean internal = outcome.still() && target.state().equals(source.state());
        Event event = events.computeIfAbsent(new Event(event(move.cause()), move.guards()), known -> known);
        return new Transition(
                source.state(),
                event,
                target.state(),
                outcome.effects(),
                internal,
                internal ? Set.of() : keeps(source, outcome.left(), target));
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

    private Set<String> keeps(Flat source, Set<Node> left, Flat target) {
        if (source.goingOn().isEmpty()) {
            return Set.of();
        }
        Set<String> keeps = new LinkedHashSet<>();
        for (Owned owned : source.goingOn()) {
            if (!left.contains(owned.owner()) && target.goingOn().contains(owned)) {
                keeps.add(name(owned));
            }
        }
        return keeps;
    }

    private Snapshot representative(Snapshot state) {
        return representatives.getOrDefault(state, state);
    }

    private Flat flat(Snapshot state) {
        return requireNonNull(flats.get(representative(state)));
    }

    private String name(Owned owned) {
        return ambiguous.contains(owned.name()) ? owned.name() + " in " + naming.of(owned.owner()) : owned.name();
    }

    private void findAmbiguous(Flat flat) {
        Set<String> names = new HashSet<>();
        for (Owned owned : flat.goingOn()) {
            if (!names.add(owned.name())) {
                ambiguous.add(owned.name());
            }
        }
    }

    /** The time triggers and activities of the active states, outer ones first. */
    private Set<Owned> goingOn(Snapshot state) {
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
