package org.evoloop.models.evolution;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;

/**
 * What the new model keeps, adds, reroutes and removes. States and events are the same if their names are, transitions if
 * they leave the same state on the same event.
 *
 * <p>Threading: immutable.
 *
 * @param transitions without those that are rerouted
 * @param rerouted transitions that lead elsewhere or have other effects
 */
public record ModelDifference(
        Parts<State> states, Parts<Event> events, Parts<Transition> transitions, List<Rerouted> rerouted) {
    public ModelDifference {
        rerouted = List.copyOf(rerouted);
    }

    /** Each in the order of the model that has it, the new one for what both have. */
    public record Parts<T>(List<T> kept, List<T> added, List<T> removed) {
        public Parts {
            kept = List.copyOf(kept);
            added = List.copyOf(added);
            removed = List.copyOf(removed);
        }

        private static <T> Parts<T> of(Collection<T> original, Collection<T> evolved) {
            return new Parts<>(
                    evolved.stream().filter(original::contains).toList(),
                    evolved.stream().filter(part -> !original.contains(part)).toList(),
                    original.stream().filter(part -> !evolved.contains(part)).toList());
        }
    }

    /** The same source and event in both models. */
    public record Rerouted(Transition before, Transition after) {}

    /** The difference between both models of {@code pair}. */
    public static ModelDifference of(ModelPair pair) {
        List<Transition> kept = new ArrayList<>();
        List<Transition> added = new ArrayList<>();
        List<Rerouted> rerouted = new ArrayList<>();
        for (Transition after : pair.evolved().transitions()) {
            Optional<Transition> before = pair.original().transition(after.source(), after.event());
            if (before.isEmpty()) {
                added.add(after);
            } else if (before.get().equals(after)) {
                kept.add(after);
            } else {
                rerouted.add(new Rerouted(before.get(), after));
            }
        }
        List<Transition> removed = pair.original().transitions().stream()
                .filter(before -> !pair.evolved().hasTransition(before.source(), before.event()))
                .toList();
        return new ModelDifference(
                Parts.of(pair.original().states(), pair.evolved().states()),
                Parts.of(pair.original().events(), pair.evolved().events()),
                new Parts<>(kept, added, removed),
                rerouted);
    }
}
