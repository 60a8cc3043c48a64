package org.evoloop.evolution;

import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/**
 * Shortest ways through the original model over events that can be sent (the paper's {@code getEvents}). Among ways of
 * equal length the one that the model names first wins, so that the answer never depends on a hash.
 *
 * <p>Threading: not thread-safe; it remembers what it has searched.
 */
final class PathPlanner {
    private final StateMachine original;
    private final Set<Event> sendable;
    private final Map<State, Map<State, Step>> arrivals = new HashMap<>();

    PathPlanner(StateMachine original, Set<Event> sendable) {
        this.original = original;
        this.sendable = sendable;
    }

    /** The steps from {@code source} to {@code target}: none if they are the same, empty if there is no way. */
    Optional<List<Step>> shortestPath(State source, State target) {
        if (source.equals(target)) {
            return Optional.of(List.of());
        }
        Map<State, Step> lastStepTo = arrivals.computeIfAbsent(source, this::search);
        Step last = lastStepTo.get(target);
        if (last == null) {
            return Optional.empty();
        }
        ArrayDeque<Step> path = new ArrayDeque<>();
        for (Step step = last; step != null; step = lastStepTo.get(step.source())) {
            path.addFirst(step);
        }
        return Optional.of(List.copyOf(path));
    }

    /** Breadth first; for each state that can be reached, the last step of the first way found. */
    private Map<State, Step> search(State source) {
        Map<State, Step> lastStepTo = new HashMap<>();
        Queue<State> frontier = new ArrayDeque<>(List.of(source));
        for (State at = frontier.poll(); at != null; at = frontier.poll()) {
            for (Transition transition : original.transitionsFrom(at)) {
                State next = transition.target();
                if (sendable.contains(transition.event()) && !next.equals(source) && !lastStepTo.containsKey(next)) {
                    lastStepTo.put(next, new Step(at, transition.event(), next, false));
                    frontier.add(next);
                }
            }
        }
        return lastStepTo;
    }
}
