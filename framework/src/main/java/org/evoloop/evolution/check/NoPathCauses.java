package org.evoloop.evolution.check;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.Turn;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/**
 * Finds what impossible decisions have in common: the state of the device that cannot be reached, or the first event of the
 * drawn way there that cannot be sent.
 */
final class NoPathCauses {
    private final StateMachine original;
    private final DeviceEvents device;
    private final List<Group> groups = new ArrayList<>();

    NoPathCauses(StateMachine original, DeviceEvents device) {
        this.original = original;
        this.device = device;
    }

    /** Turns of one cause, in order, and what cannot be sent. */
    record Group(List<Turn> turns, Set<State> targets, Set<Event> unsendable) {}

    void add(Turn turn, State target) {
        Configuration after = turn.decision().after();
        Optional<Event> missing = firstUnsendable(after.original(), target);
        Group mine = new Group(new ArrayList<>(), new HashSet<>(), new HashSet<>());
        List<Group> joined = groups.stream()
                .filter(group -> group.targets().contains(target)
                        || missing.filter(group.unsendable()::contains).isPresent())
                .toList();
        Group group = joined.isEmpty() ? mine : joined.get(0);
        joined.stream().skip(1).forEach(other -> {
            group.turns().addAll(other.turns());
            group.targets().addAll(other.targets());
            group.unsendable().addAll(other.unsendable());
            groups.remove(other);
        });
        group.turns().add(turn);
        group.targets().add(target);
        missing.ifPresent(group.unsendable()::add);
        if (joined.isEmpty()) {
            groups.add(group);
        }
    }

    List<Group> groups() {
        return groups;
    }

    /** On the shortest way of all that are drawn; empty if there is none, or all of it can be sent. */
    private Optional<Event> firstUnsendable(State source, State target) {
        Map<State, Transition> arrivals = new HashMap<>();
        Queue<State> frontier = new ArrayDeque<>(List.of(source));
        for (State at = frontier.poll(); at != null && !arrivals.containsKey(target); at = frontier.poll()) {
            for (Transition transition : original.transitionsFrom(at)) {
                if (!transition.target().equals(source)
                        && arrivals.putIfAbsent(transition.target(), transition) == null) {
                    frontier.add(transition.target());
                }
            }
        }
        Event first = null;
        for (State at = target; arrivals.containsKey(at); ) {
            Transition last = Objects.requireNonNull(arrivals.get(at));
            Event trigger = last.event().trigger();
            first = device.sendable().contains(trigger) ? first : trigger;
            at = last.source();
        }
        return Optional.ofNullable(first);
    }
}
