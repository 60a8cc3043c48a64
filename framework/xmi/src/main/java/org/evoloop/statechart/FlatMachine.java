package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.Arrays;
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

/** Builds the flat machine from the results of an {@link Explorer}, and names its states. */
final class FlatMachine {
    private final Net net;
    private final FlatNames naming;
    /** In document order. */
    private final List<Flat> flats = new ArrayList<>();
    /** The flat state of each state found, by number. */
    private final Flat[] byNumber;
    /** Their states, since every transition needs the one that it leads to. */
    private final State[] states;

    private final Map<String, Event> unguarded = new HashMap<>();
    private final Map<Event, Event> guarded = new HashMap<>();
    /** The time triggers and activities that several active states share. */
    private final Set<String> ambiguous = new HashSet<>();

    private final Set<Problem> problems = new LinkedHashSet<>();

    /**
     * @param reached every stable state, by number
     * @param inOrder every stable state, in document order
     */
    FlatMachine(Net net, List<Reached> reached, List<Reached> inOrder) {
        this.net = net;
        this.byNumber = new Flat[reached.size()];
        this.states = new State[reached.size()];
        List<Reached> representatives = Histories.merge(reached);
        List<Reached> ordered = inOrder.stream()
                .filter(state -> representatives.get(state.index) == state)
                .toList();
        this.naming =
                new FlatNames(net, ordered.stream().map(state -> state.snapshot).toList());
        List<String> names = naming.all();
        List<String> plain = naming.withoutMemory(names);
        for (Reached state : ordered) {
            int number = flats.size();
            State named = new State(names.get(number));
            boolean itself = plain.get(number).equals(named.name());
            Flat flat = new Flat(state, named, itself ? named : new State(plain.get(number)), goingOn(state.snapshot));
            flats.add(flat);
            byNumber[state.index] = flat;
            findAmbiguous(flat);
        }
        for (Reached state : reached) {
            Flat flat = byNumber[representatives.get(state.index).index];
            byNumber[state.index] = flat;
            states[state.index] = flat.state();
        }
    }

    /** @param plain the state without its memory */
    private record Flat(Reached reached, State state, State plain, Set<Owned> goingOn) {}

    /** A timer or an activity that runs while a drawn state is active. */
    private record Owned(Node owner, String name, boolean activity) {}

    /** The innermost vertices of each flat state. */
    Map<State, List<Vertex>> leaves() {
        Map<State, List<Vertex>> leaves = new LinkedHashMap<>();
        for (Flat flat : flats) {
            List<Vertex> vertices = new ArrayList<>();
            for (int leaf : flat.reached().snapshot.leaves()) {
                vertices.add(net.node(leaf).vertex);
            }
            leaves.put(flat.state(), List.copyOf(vertices));
        }
        return leaves;
    }

    /** What {@link #machine} has found: regions that contradict each other. */
    Set<Problem> problems() {
        return problems;
    }

    /** @param effects run when the machine starts, in order */
    StateMachine machine(Reached start, List<String> effects) {
        StateMachineBuilder builder = StateMachine.named(net.chart().name());
        boolean usesDevice =
                net.nodes().stream().anyMatch(node -> !ActiveUse.drawnAt(node).isNone());
        for (Flat flat : flats) {
            List<String> activities = new ArrayList<>();
            for (Owned owned : flat.goingOn()) {
                if (owned.activity()) {
                    activities.add(name(owned));
                }
            }
            StableConfiguration drawn = flat.reached().snapshot;
            builder.drawn(flat.state(), flat.plain(), activities, paths(drawn), isEnd(drawn));
            if (usesDevice) {
                use(drawn, flat.state().name(), builder);
            }
        }
        builder.initial(states[start.index].name()).initialEffects(effects);
        List<Transition> leaving = new ArrayList<>();
        for (Flat flat : flats) {
            List<Move> moves = flat.reached().moves;
            for (int i = 0; i < moves.size(); i++) {
                Move move = moves.get(i);
                if (move.deferred()) {
                    builder.defers(flat.state().name(), event(move.cause().name(), move.guards()));
                }
                // A guarded deferral must also be a transition, so that it takes precedence over the ones after it.
                if (!move.deferred() || !move.guards().isEmpty()) {
                    leaving.add(transition(flat, move));
                }
            }
            builder.transitions(flat.state(), leaving);
            leaving.clear();
        }
        net.spontaneous().forEach(event -> builder.spontaneous(new Event(event)));
        net.urgent().forEach(event -> builder.urgent(new Event(event)));
        net.chart().events().stream()
                .filter(event -> !event.isBlank())
                .forEach(event -> builder.event(new Event(event)));
        return builder.build();
    }

    private void use(StableConfiguration drawn, String state, StateMachineBuilder builder) {
        try {
            ActiveUse use = ActiveUse.of(net, drawn.leaves());
            use.sends().forEach(event -> builder.sends(state, event));
            if (!use.device().isEmpty() && use.inherited()) {
                builder.inheritedDeviceState(state, use.device());
            } else if (!use.device().isEmpty()) {
                builder.deviceState(state, use.device());
            }
        } catch (Refused contradiction) {
            problems.add(contradiction.problem());
        }
    }

    private List<String> paths(StableConfiguration state) {
        int[] leaves = state.leaves();
        if (leaves.length == 1) {
            return List.of(net.node(leaves[0]).path());
        }
        return Arrays.stream(leaves).mapToObj(leaf -> net.node(leaf).path()).toList();
    }

    private boolean isEnd(StableConfiguration state) {
        for (int leaf : state.leaves()) {
            if (!net.node(leaf).isFinal() && !net.node(leaf).is(Vertex.Kind.TERMINATE)) {
                return false;
            }
        }
        return true;
    }

    private Transition transition(Flat source, Move move) {
        State target = states[move.target()];
        boolean internal = move.still() && target.equals(source.state());
        return new Transition(
                source.state(),
                event(name(move.cause()), move.guards()),
                target,
                move.effects(),
                internal,
                internal || source.goingOn().isEmpty()
                        ? Set.of()
                        : keeps(source, move.left(), byNumber[move.target()]));
    }

    /** Returns the same object for equal events, since there are far fewer events than transitions. */
    private Event event(String name, List<String> guards) {
        return guards.isEmpty()
                ? unguarded.computeIfAbsent(name, Event::new)
                : guarded.computeIfAbsent(new Event(name, guards), event -> event);
    }

    private String name(Cause cause) {
        Node owner = cause.owner();
        if (owner == null) {
            return cause.name();
        }
        return cause.kind() == Cause.Kind.TIME
                ? name(new Owned(owner, cause.name(), false))
                : "completion(" + naming.of(owner) + ")";
    }

    private Set<String> keeps(Flat source, Set<Node> left, Flat target) {
        Set<String> keeps = new LinkedHashSet<>();
        for (Owned owned : source.goingOn()) {
            if (!left.contains(owned.owner()) && target.goingOn().contains(owned)) {
                keeps.add(name(owned));
            }
        }
        return keeps;
    }

    private String name(Owned owned) {
        return ambiguous.contains(owned.name()) ? owned.name() + " in " + naming.of(owned.owner()) : owned.name();
    }

    private void findAmbiguous(Flat flat) {
        if (flat.goingOn().size() < 2) {
            return;
        }
        Set<String> names = new HashSet<>();
        for (Owned owned : flat.goingOn()) {
            if (!names.add(owned.name())) {
                ambiguous.add(owned.name());
            }
        }
    }

    /** The time triggers and activities of the active states, outer ones first. */
    private Set<Owned> goingOn(StableConfiguration state) {
        if (net.isCalm()) {
            return Set.of();
        }
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

    private List<Node> active(StableConfiguration state) {
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
