package org.evoloop.page.drawing;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/**
 * A machine as rows of boxes: states are in even rows, by their distance from the initial one, and the arrows' labels
 * in odd ones, as boxes of their own, so that no text overlaps anything. A long arrow has a thin box in each row that
 * it crosses.
 */
final class Graph {
    static final double CHAR = 7.6;
    static final double STATE_HEIGHT = 40;
    static final double LINE = 17;

    /** An item that takes room in a row. */
    static final class Box {
        final int row;
        final double width;
        final double height;
        final List<Box> neighbours = new ArrayList<>();
        double x;
        double y;

        Box(int row, double width, double height) {
            this.row = row;
            this.width = width;
            this.height = height;
        }
    }

    /**
     * All transitions from one state to another.
     *
     * @param way the boxes from its source to its target, both included
     * @param label the box with its texts
     */
    record Arrow(State source, State target, List<Transition> transitions, List<Box> way, Box label) {}

    final Map<State, Box> states = new LinkedHashMap<>();
    final List<Arrow> arrows = new ArrayList<>();
    final List<List<Box>> rows = new ArrayList<>();

    Graph(StateMachine machine) {
        Map<State, Integer> distances = distances(machine);
        machine.states()
                .forEach(state -> states.put(
                        state,
                        box(2 * distances.getOrDefault(state, 0), state.name().length() * CHAR + 26, STATE_HEIGHT)));
        Map<List<State>, List<Transition>> between = new LinkedHashMap<>();
        for (Transition transition : machine.transitions()) {
            between.computeIfAbsent(List.of(transition.source(), transition.target()), ends -> new ArrayList<>())
                    .add(transition);
        }
        between.forEach((ends, transitions) -> arrows.add(arrow(ends.get(0), ends.get(1), transitions)));
    }

    private static Map<State, Integer> distances(StateMachine machine) {
        Map<State, Integer> distances = new LinkedHashMap<>(Map.of(machine.initial(), 0));
        Deque<State> next = new ArrayDeque<>(List.of(machine.initial()));
        while (!next.isEmpty()) {
            State source = next.remove();
            int distance = distances.getOrDefault(source, 0);
            for (Transition transition : machine.transitionsFrom(source)) {
                if (distances.putIfAbsent(transition.target(), distance + 1) == null) {
                    next.add(transition.target());
                }
            }
        }
        return distances;
    }

    /** The box of a state. */
    Box box(State state) {
        return Objects.requireNonNull(states.get(state));
    }

    private Box box(int row, double width, double height) {
        while (rows.size() <= row) {
            rows.add(new ArrayList<>());
        }
        Box box = new Box(row, width, height);
        rows.get(row).add(box);
        return box;
    }

    private Arrow arrow(State source, State target, List<Transition> transitions) {
        Box from = box(source);
        Box to = box(target);
        double width = transitions.stream()
                .mapToDouble(each -> text(each).length() * CHAR * 0.9 + 14)
                .max()
                .orElse(0);
        double height = transitions.size() * LINE + 6;
        List<Box> way = new ArrayList<>(List.of(from));
        Box label;
        if (Math.abs(from.row - to.row) < 2) {
            label = box(from.row + 1, width, height);
            way.add(label);
        } else {
            int step = Integer.signum(to.row - from.row);
            // On the way down near the source, on the way up near the target: where there is most room.
            int labelRow = Math.min(from.row, to.row) + 1;
            label = box(labelRow, width, height);
            for (int row = from.row + step; row != to.row; row += step) {
                way.add(row == labelRow ? label : box(row, 10, 1));
            }
        }
        way.add(to);
        for (int index = 1; index < way.size(); index++) {
            way.get(index - 1).neighbours.add(way.get(index));
            way.get(index).neighbours.add(way.get(index - 1));
        }
        return new Arrow(source, target, transitions, way, label);
    }

    /** As on a diagram: event, guards and effects. */
    static String text(Transition transition) {
        String event = transition.event().toString();
        return transition.effects().isEmpty() ? event : event + " / " + String.join("; ", transition.effects());
    }
}
