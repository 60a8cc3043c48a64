package org.evoloop.models.evolution;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statechart.DeviceUse;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;

/**
 * What the new model keeps, adds, reroutes and removes. Two states are the same if their names are, whatever the
 * machine remembers in them; two events if their names are; two transitions if they leave the same state on the same
 * event.
 *
 * <p>Threading: immutable.
 *
 * @param transitions without those that are rerouted
 * @param rerouted transitions with another target or other effects
 * @param uses states of the new model with a device state or sends that they did not have before, or no longer have
 */
public record ModelDifference(
        Parts<State> states,
        Parts<Event> events,
        Parts<Transition> transitions,
        List<Rerouted> rerouted,
        List<UseChange> uses) {
    public ModelDifference {
        rerouted = List.copyOf(rerouted);
        uses = List.copyOf(uses);
    }

    /** Each in the order of its model; {@code kept} in the order of the new model. */
    public record Parts<T>(List<T> kept, List<T> added, List<T> removed) {
        public Parts {
            kept = List.copyOf(kept);
            added = List.copyOf(added);
            removed = List.copyOf(removed);
        }

        private static <T> Parts<T> of(
                Collection<T> original, Predicate<T> kept, Collection<T> evolved, Predicate<T> added) {
            return new Parts<>(
                    evolved.stream().filter(added.negate()).toList(),
                    evolved.stream().filter(added).toList(),
                    original.stream().filter(kept.negate()).toList());
        }
    }

    /** Two transitions with the same source and event, one of each model. */
    public record Rerouted(Transition before, Transition after) {}

    /** What a state of the new model has to do with the device, and what it had before. */
    public record UseChange(State state, DeviceUse before, DeviceUse after) {}

    /** The difference between the two models of {@code pair}. */
    public static ModelDifference of(ModelPair pair) {
        List<Transition> kept = new ArrayList<>();
        List<Transition> added = new ArrayList<>();
        List<Rerouted> rerouted = new ArrayList<>();
        for (Transition after : pair.evolved().transitions()) {
            List<Transition> before = pair.deviceStates(after.source()).stream()
                    .flatMap(source -> pair.original().transition(source, after.event()).stream())
                    .toList();
            if (before.isEmpty()) {
                added.add(after);
            } else if (before.stream().anyMatch(one -> isSame(one, after, pair))) {
                kept.add(after);
            } else {
                rerouted.add(new Rerouted(before.get(0), after));
            }
        }
        List<Transition> removed = pair.original().transitions().stream()
                .filter(before -> pair.evolvedStates(before.source()).stream()
                        .noneMatch(source -> pair.evolved().hasTransition(source, before.event())))
                .toList();
        Set<Event> known = pair.original().events();
        Set<Event> heard = pair.evolved().events();
        return new ModelDifference(
                Parts.of(
                        pair.original().states(),
                        state -> !pair.evolvedStates(state).isEmpty(),
                        pair.evolved().states(),
                        pair::isNew),
                Parts.of(known, heard::contains, heard, event -> !known.contains(event)),
                new Parts<>(kept, added, removed),
                rerouted,
                pair.evolved().states().stream()
                        .map(state -> use(pair, state))
                        .filter(use -> !use.before().equals(use.after()))
                        .toList());
    }

    private static UseChange use(ModelPair pair, State state) {
        DeviceUse before = pair.deviceStates(state).stream()
                .findFirst()
                .map(same -> DeviceUse.of(pair.original(), same))
                .orElse(DeviceUse.NONE);
        return new UseChange(state, before, DeviceUse.of(pair.evolved(), state));
    }

    private static boolean isSame(Transition before, Transition after, ModelPair pair) {
        return pair.deviceStates(after.target()).contains(before.target())
                && before.effects().equals(after.effects())
                && before.internal() == after.internal()
                && before.keeps().equals(after.keeps());
    }
}
