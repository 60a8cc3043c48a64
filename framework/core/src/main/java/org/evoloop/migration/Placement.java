package org.evoloop.migration;

import java.util.List;
import java.util.Map;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.jspecify.annotations.Nullable;

/**
 * Where the running models' states are in the next ones: where the mapping says, else under the same name, else drawn in the
 * same place.
 *
 * <p>Threading: not thread-safe.
 */
final class Placement {
    private final DecisionTable next;
    private final Mapping mapping;
    private final StateMachine oldDevice;
    private final StateMachine oldSystem;
    private final Belongings belongings;

    Placement(DecisionTable running, DecisionTable next, Mapping mapping) {
        this.next = next;
        this.mapping = mapping;
        this.oldDevice = running.models().original();
        this.oldSystem = running.models().evolved();
        this.belongings = new Belongings(running, next, mapping);
    }

    /** What becomes of {@code at} now; {@link Fate.Stuck} if nothing can, whatever may happen later. */
    Fate fate(Configuration at) {
        State device = same(at.original(), oldDevice, next.models().original(), mapping.device(), null);
        if (device == null) {
            return unknown("original", "device", at.original());
        }
        State system = same(at.evolved(), oldSystem, next.models().evolved(), mapping.states(), device);
        if (system == null) {
            return unknown("new", "state", at.evolved());
        }
        Decision settled = next.settle(new Configuration(device, system));
        if (settled instanceof Decision.Impossible impossible) {
            return new Fate.Stuck(impossible.reason());
        }
        return new Fate.Maps(settled.after(), settled.steps(), belongings.carried(at.evolved(), system));
    }

    private static Fate unknown(String model, String keyword, State state) {
        return new Fate.Stuck("the next " + model + " model has no state " + state + "; map it: " + keyword + " "
                + state + " -> STATE");
    }

    /** @param device where the device will be, which tells apart states that differ in what is remembered; null if not known */
    private @Nullable State same(
            State state, StateMachine old, StateMachine now, Map<State, State> mapped, @Nullable State device) {
        State plain = old.withoutMemory(state);
        State wanted = mapped.getOrDefault(state, mapped.get(plain));
        List<State> candidates = now.alike(wanted == null ? state : wanted);
        if (candidates.isEmpty()) {
            candidates = now.alike(wanted == null ? plain : wanted);
        }
        if (candidates.isEmpty() && wanted == null) {
            List<String> drawn = old.paths(state);
            candidates = now.states().stream()
                    .filter(other -> now.paths(other).equals(drawn))
                    .toList();
        }
        for (State candidate : candidates) {
            if (candidate.equals(state)
                    || (device != null && next.configurations().contains(new Configuration(device, candidate)))) {
                return candidate;
            }
        }
        return candidates.isEmpty() ? null : candidates.get(0);
    }
}
