package org.evoloop.check;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.function.Predicate;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.Turn;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/**
 * Groups impossible decisions by their cause: the state of the device that cannot be reached, or the first event on the
 * drawn path there that cannot be sent.
 */
final class NoPathCauses {
    private final StateMachine original;
    private final DeviceEvents device;
    private final List<Group> groups = new ArrayList<>();

    NoPathCauses(StateMachine original, DeviceEvents device) {
        this.original = original;
        this.device = device;
    }

    /** The turns with one cause, in order, and the transitions on events that cannot be sent. */
    record Group(List<Turn> turns, Set<State> targets, Set<Transition> missing) {
        Set<Event> unsendable() {
            Set<Event> events = new LinkedHashSet<>();
            missing.forEach(transition -> events.add(transition.event().trigger()));
            return events;
        }
    }

    /** @param targets the device's states of which one is wanted; several if they differ in their history */
    void add(Turn turn, List<State> targets) {
        Configuration after = turn.decision().after();
        Optional<Transition> missing = firstUnsendable(after.original(), targets);
        Group mine = new Group(new ArrayList<>(), new HashSet<>(), new LinkedHashSet<>());
        List<Group> joined = groups.stream()
                .filter(group -> targets.stream().anyMatch(group.targets()::contains)
                        || missing.map(transition -> transition.event().trigger())
                                .filter(group.unsendable()::contains)
                                .isPresent())
                .toList();
        Group group = joined.isEmpty() ? mine : joined.get(0);
        joined.stream().skip(1).forEach(other -> {
            group.turns().addAll(other.turns());
            group.targets().addAll(other.targets());
            group.missing().addAll(other.missing());
            groups.remove(other);
        });
        group.turns().add(turn);
        group.targets().addAll(targets);
        missing.ifPresent(group.missing()::add);
        if (joined.isEmpty()) {
            groups.add(group);
        }
    }

    List<Group> groups() {
        return groups;
    }

    /** The one on the shortest drawn path; empty if there is no path, or all of its events can be sent. */
    private Optional<Transition> firstUnsendable(State source, List<State> targets) {
        Map<State, Transition> arrivals = new HashMap<>();
        Queue<State> frontier = new ArrayDeque<>(List.of(source));
        Predicate<State> isReached = arrivals::containsKey;
        for (State at = frontier.poll(); at != null && targets.stream().noneMatch(isReached); at = frontier.poll()) {
            for (Transition transition : original.transitionsFrom(at)) {
                if (!transition.target().equals(source)
                        && arrivals.putIfAbsent(transition.target(), transition) == null) {
                    frontier.add(transition.target());
                }
            }
        }
        Transition first = null;
        Transition last = targets.stream()
                .filter(isReached)
                .findFirst()
                .map(arrivals::get)
                .orElse(null);
        while (last != null) {
            Event trigger = last.event().trigger();
            first = device.sendable().contains(trigger) ? first : last;
            last = arrivals.get(last.source());
        }
        return Optional.ofNullable(first);
    }
}
