package org.evoloop.page.drawing;

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
 * and each knows the composite states around it.
 *
 * @param around the composite states around each state, the outermost first
 * @param arrows without those that are the same
 */
record Sketch(State initial, Map<State, List<String>> around, Set<Line> arrows) {
    /** An arrow and its text. */
    record Line(State source, State target, String event, String text) {}

    /** @param closed whether a composite state is drawn as one box */
    static Sketch of(StateMachine machine, boolean closed) {
        Map<State, State> drawn = new LinkedHashMap<>();
        Map<State, List<String>> around = new LinkedHashMap<>();
        for (State state : machine.states()) {
            List<String> frames = around(machine, state);
            State box = closed && !frames.isEmpty() ? new State(frames.get(0)) : machine.withoutMemory(state);
            drawn.put(state, box);
            around.putIfAbsent(box, closed ? List.of() : frames);
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
        return new Sketch(drawn.getOrDefault(machine.initial(), machine.initial()), around, arrows);
    }

    /** The arrows that {@code before} has not, with their states and the initial one. */
    Sketch without(Sketch before) {
        Set<Line> more = new LinkedHashSet<>(arrows);
        more.removeAll(before.arrows());
        Map<State, List<String>> drawn = new LinkedHashMap<>(around);
        drawn.keySet()
                .removeIf(state -> !state.equals(initial)
                        && more.stream()
                                .noneMatch(line -> line.source().equals(state)
                                        || line.target().equals(state)));
        return new Sketch(initial, drawn, more);
    }

    /**
     * The composite states in which {@code state} is drawn, the outermost first. Of a state with several regions, those
     * around all of them.
     */
    static List<String> around(StateMachine machine, State state) {
        if (machine.isDrawnFlat()) {
            return List.of();
        }
        List<List<String>> all = machine.paths(state).stream()
                .map(path -> List.of(path.split("\\.")))
                .map(names -> names.subList(0, names.size() - 1))
                .toList();
        List<String> first = all.get(0);
        int shared = 0;
        while (shared < first.size() && isShared(all, first, shared)) {
            shared++;
        }
        return first.subList(0, shared);
    }

    private static boolean isShared(List<List<String>> all, List<String> first, int depth) {
        return all.stream()
                .allMatch(names -> depth < names.size() && names.get(depth).equals(first.get(depth)));
    }

    /** As on a diagram: event, guards and effects. */
    private static String text(Transition transition) {
        String event = transition.event().toString();
        return transition.effects().isEmpty() ? event : event + " / " + String.join("; ", transition.effects());
    }

    /** Whether any state is drawn inside another. */
    boolean hasComposites() {
        return around.values().stream().anyMatch(frames -> !frames.isEmpty());
    }
}
