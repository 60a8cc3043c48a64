package org.evoloop.page.drawing;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/**
 * What of a machine is drawn: states that differ only in what the machine remembers are one, as their author drew them,
 * and each knows the composite state around it.
 *
 * @param outer the outermost composite state around each state; empty for none
 * @param arrows without those that are the same
 */
record Sketch(State initial, Map<State, String> outer, Set<Line> arrows) {
    /** An arrow and its text. */
    record Line(State source, State target, String event, String text) {}

    /** @param closed whether a composite state is drawn as one box */
    static Sketch of(StateMachine machine, boolean closed) {
        Map<State, State> drawn = new LinkedHashMap<>();
        Map<State, String> outer = new LinkedHashMap<>();
        for (State state : machine.states()) {
            String around = outer(machine, state);
            State box = closed && !around.isEmpty() ? new State(around) : machine.withoutMemory(state);
            drawn.put(state, box);
            outer.putIfAbsent(box, closed ? "" : around);
        }
        Set<Line> arrows = new LinkedHashSet<>();
        for (Transition each : machine.transitions()) {
            State source = drawn.getOrDefault(each.source(), each.source());
            State target = drawn.getOrDefault(each.target(), each.target());
            boolean inside = source.equals(target) && !each.source().equals(each.target());
            if (!closed || !inside) {
                arrows.add(new Line(source, target, each.event().toString(), text(each)));
            }
        }
        return new Sketch(drawn.getOrDefault(machine.initial(), machine.initial()), outer, arrows);
    }

    /** The arrows that {@code before} has not, with their states and the initial one. */
    Sketch without(Sketch before) {
        Set<Line> more = new LinkedHashSet<>(arrows);
        more.removeAll(before.arrows());
        Map<State, String> drawn = new LinkedHashMap<>(outer);
        drawn.keySet()
                .removeIf(state -> !state.equals(initial)
                        && more.stream()
                                .noneMatch(line -> line.source().equals(state)
                                        || line.target().equals(state)));
        return new Sketch(initial, drawn, more);
    }

    /** The outermost composite state in which {@code state} is drawn; empty if it is at the top, or in no single one. */
    static String outer(StateMachine machine, State state) {
        List<String> around = new ArrayList<>();
        for (String path : machine.paths(state)) {
            int end = path.indexOf('.');
            around.add(end < 0 || path.equals(state.name()) ? "" : path.substring(0, end));
        }
        return around.stream().distinct().count() == 1 ? around.get(0) : "";
    }

    /** As on a diagram: event, guards and effects. */
    private static String text(Transition transition) {
        String event = transition.event().toString();
        return transition.effects().isEmpty() ? event : event + " / " + String.join("; ", transition.effects());
    }

    /** Whether any state is drawn inside another. */
    boolean hasComposites() {
        return outer.values().stream().anyMatch(name -> !name.isEmpty());
    }
}
