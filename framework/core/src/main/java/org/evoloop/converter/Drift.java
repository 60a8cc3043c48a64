package org.evoloop.converter;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * Which of its last acts the device's model does not have. An act is what the device did by itself, what a person did at the
 * device, and an event that was sent to it and that it obeyed.
 *
 * <p>Threading: immutable.
 *
 * @param acts how many acts this is about: the last 200 at most, since the models took over or the process began
 * @param edges those that the model does not have, the most frequent first
 * @since 0.1
 */
public record Drift(int acts, List<Edge> edges) {
    /** No act yet. */
    public static final Drift NONE = new Drift(0, List.of());

    private static final int NAMED = 3;

    /**
     * Acts of one kind.
     *
     * @param source where the model had the device before
     * @param event what happened; null if it was not seen how the device came to its target
     * @param target where the device was then; null if it has not said so
     * @param count how many of the acts
     */
    public record Edge(
            State source, @Nullable Event event, @Nullable State target, int count) {
        /** Source and count may not be missing. */
        public Edge {
            requireNonNull(source, "the source of an edge is null");
        }

        /** As a line of text: {@code Clean --Spot--> On}; a question mark stands for what was not seen. */
        @Override
        public String toString() {
            return source + " --" + (event == null ? "?" : event) + "--> " + (target == null ? "?" : target);
        }
    }

    /** Sorts the edges. */
    public Drift {
        edges = edges.stream()
                .sorted(Comparator.comparingInt(Edge::count).reversed())
                .toList();
    }

    /** How many of the acts are not in the model. */
    public int unexplained() {
        return edges.stream().mapToInt(Edge::count).sum();
    }

    /**
     * The original model with what was seen instead: each event leads from its state to where the device was then. Acts
     * whose event or target was not seen are left out.
     *
     * @param original the model in terms of which these edges are
     */
    public StateMachine explained(StateMachine original) {
        List<Transition> seen = new ArrayList<>();
        Set<List<Object>> taken = new HashSet<>();
        for (Edge edge : edges) {
            Event event = edge.event();
            State target = edge.target();
            if (event != null && target != null && taken.add(List.of(edge.source(), event.trigger()))) {
                seen.add(new Transition(edge.source(), event.trigger(), target));
            }
        }
        return copy(original, seen, taken);
    }

    private static StateMachine copy(StateMachine original, List<Transition> seen, Set<List<Object>> taken) {
        StateMachineBuilder copy = StateMachine.named(original.name())
                .initial(original.initial().name())
                .initialEffects(original.initialEffects());
        original.states().forEach(state -> {
            copy.state(state.name());
            copy.activities(state.name(), original.activities(state));
        });
        original.spontaneous().forEach(copy::spontaneous);
        original.transitions().stream()
                .filter(transition -> !taken.contains(
                        List.of(transition.source(), transition.event().trigger())))
                .forEach(transition -> copy.transition(transition, ""));
        seen.forEach(transition -> copy.transition(transition, ""));
        return copy.build();
    }

    /** For people: {@code 3 of the last 200 acts are not in the model: Clean --Spot--> On}; empty if all are. */
    @Override
    public String toString() {
        int missing = unexplained();
        if (missing == 0) {
            return "";
        }
        String named = edges.stream()
                .limit(NAMED)
                .map(edge -> edge + (edges.size() > 1 ? " (" + edge.count() + ")" : ""))
                .collect(Collectors.joining(", "));
        int more = edges.size() - NAMED;
        return missing + " of the last " + acts + " acts " + (missing == 1 ? "is" : "are") + " not in the model: "
                + named + (more > 0 ? " and " + more + " more" : "");
    }
}
