package org.evoloop.evolution;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/**
 * Gives the states of two machines that are drawn in the same place the same name. A flat state is called {@code On}, or
 * {@code Power.On} where its machine has another {@code On}, so that a state that only one machine has may change the name
 * of one that both have.
 */
final class Namesakes {
    private final StateMachine original;
    private final StateMachine evolved;
    private final Map<State, String> originalNames = new LinkedHashMap<>();
    private final Map<State, String> evolvedNames = new LinkedHashMap<>();

    Namesakes(StateMachine original, StateMachine evolved) {
        this.original = original;
        this.evolved = evolved;
        Map<List<String>, List<State>> byPaths = new HashMap<>();
        evolved.states()
                .forEach(state -> byPaths.computeIfAbsent(evolved.paths(state), paths -> new ArrayList<>(1))
                        .add(state));
        for (State state : original.states()) {
            List<State> same = byPaths.getOrDefault(original.paths(state), List.of());
            // Several differ in what is remembered.
            if (same.size() == 1 && !same.get(0).equals(state)) {
                match(state, same.get(0));
            }
        }
    }

    /** The name that the device has for it, unless the new model needs that for another state. */
    private void match(State state, State same) {
        if (!evolved.hasState(state) && !evolvedNames.containsValue(state.name())) {
            evolvedNames.put(same, state.name());
        } else if (!original.hasState(same)) {
            originalNames.put(state, same.name());
        }
    }

    StateMachine original() {
        return originalNames.isEmpty() ? original : original.withStateNames(originalNames);
    }

    StateMachine evolved() {
        return evolvedNames.isEmpty() ? evolved : evolved.withStateNames(evolvedNames);
    }
}
