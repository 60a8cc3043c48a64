package org.evoloop.evolution;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/**
 * Gives the states of two machines that are drawn in the same place the same name. A flat state is called {@code On},
 * or {@code Power.On} where its machine has another {@code On}, so that a state that only one machine has may change
 * the name of one that both have.
 */
final class Namesakes {
    private final StateMachine original;
    private final StateMachine evolved;
    private final Map<State, String> originalNames = new LinkedHashMap<>();
    private final Map<State, String> evolvedNames = new LinkedHashMap<>();

    Namesakes(StateMachine original, StateMachine evolved) {
        this.original = original;
        this.evolved = evolved;
        if (original.isDrawnFlat() && evolved.isDrawnFlat()) {
            return;
        }
        Map<List<String>, List<State>> sameInEvolved = byPaths(evolved);
        byPaths(original).forEach((paths, states) -> {
            List<State> same = sameInEvolved.getOrDefault(paths, List.of());
            if (isOne(states, original) && isOne(same, evolved)) {
                match(states, same);
            }
        });
    }

    private static Map<List<String>, List<State>> byPaths(StateMachine machine) {
        Map<List<String>, List<State>> byPaths = new LinkedHashMap<>();
        machine.states()
                .forEach(state -> byPaths.computeIfAbsent(machine.paths(state), paths -> new ArrayList<>(1))
                        .add(state));
        return byPaths;
    }

    /** Whether they are one state except for the remembered history. */
    private static boolean isOne(List<State> states, StateMachine machine) {
        return states.size() == 1
                || states.stream().map(machine::withoutMemory).distinct().count() == 1;
    }

    /** Uses the device's name for the state, unless the new model needs that name for another state. */
    private void match(List<State> states, List<State> same) {
        State plain = original.withoutMemory(states.get(0));
        State other = evolved.withoutMemory(same.get(0));
        if (plain.equals(other)) {
            return;
        }
        if (evolved.alike(plain).isEmpty() && !evolvedNames.containsValue(plain.name())) {
            rename(same, other, plain, evolvedNames);
        } else if (original.alike(other).isEmpty()) {
            rename(states, plain, other, originalNames);
        }
    }

    /** Renames a state together with its history. */
    private static void rename(List<State> states, State from, State to, Map<State, String> names) {
        names.put(from, to.name());
        for (State state : states) {
            names.put(state, to.name() + state.name().substring(from.name().length()));
        }
    }

    StateMachine original() {
        return originalNames.isEmpty() ? original : original.withStateNames(originalNames);
    }

    StateMachine evolved() {
        StateMachine renamed = evolvedNames.isEmpty() ? evolved : evolved.withStateNames(evolvedNames);
        for (State state : renamed.states()) {
            String device = renamed.deviceState(state);
            String same = device == null ? null : originalNames.get(new State(device));
            if (same != null) {
                renamed = renamed.withDeviceState(state, same);
            }
        }
        return renamed;
    }
}
