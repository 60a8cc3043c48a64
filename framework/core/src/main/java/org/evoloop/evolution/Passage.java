package org.evoloop.evolution;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/**
 * A state of the device on a path.
 *
 * <p>Threading: immutable.
 *
 * @param effects what the device does on the way through it, as drawn; often nothing
 * @since 0.1
 */
public record Passage(State state, List<String> effects) {
    public Passage {
        effects = List.copyOf(effects);
    }

    /** The states through which the device passes, in order, without the last. */
    public static List<Passage> of(Decision decision, StateMachine original) {
        List<Passage> all = new ArrayList<>();
        for (State state : decision.passed()) {
            Set<String> effects = new LinkedHashSet<>(original.activities(state));
            decision.steps().stream()
                    .filter(step -> !step.byDevice() && step.target().equals(state))
                    .forEach(step -> effects.addAll(step.effects()));
            all.add(new Passage(state, List.copyOf(effects)));
        }
        return all;
    }
}
