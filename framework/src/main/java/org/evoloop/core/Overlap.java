package org.evoloop.core;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * A step that was on its way while the device acted by itself: what the device did is known in its order, but not what of it
 * came before the step had its effect, and what after.
 */
final class Overlap {
    /** Of more than so many facts nobody keeps count; then nothing is sure. */
    static final int MOST_FACTS = 64;

    private final DecisionTable table;
    private final Step step;
    private final boolean counted;

    /** Where the device is if the step came before all of it, after the first of it, and so on to after all of it. */
    private final List<State> ends = new ArrayList<>();

    Overlap(DecisionTable table, Step step, List<Occurrence> meanwhile) {
        this.table = table;
        this.step = step;
        this.counted = meanwhile.size() < MOST_FACTS;
        State before = step.source();
        for (int place = 0; counted && place <= meanwhile.size(); place++) {
            State state = takes(before);
            for (Occurrence fact : meanwhile.subList(place, meanwhile.size())) {
                state = follows(state, fact);
            }
            ends.add(state);
            if (place < meanwhile.size()) {
                before = follows(before, meanwhile.get(place));
            }
        }
    }

    /** {@code meanwhile} and {@code fact}, if that still counts. */
    static List<Occurrence> with(List<Occurrence> meanwhile, Occurrence fact) {
        if (meanwhile.size() >= MOST_FACTS) {
            return meanwhile;
        }
        List<Occurrence> more = new ArrayList<>(meanwhile);
        more.add(fact);
        return List.copyOf(more);
    }

    /** Where the device is by the order in which it was told: the step came last, when all else had led to {@code last}. */
    State asTold(State last) {
        return takes(last);
    }

    /** Whether the device is in {@code state} in whatever order it happened. */
    boolean isSure(State state) {
        return counted && ends.stream().allMatch(state::equals);
    }

    private State takes(State from) {
        return from.equals(step.source())
                ? step.target()
                : targetOf(table.ownStep(from, step.trigger(), guard -> false), from);
    }

    private State follows(State from, Occurrence fact) {
        if (fact instanceof Occurrence.Found found) {
            return found.state();
        }
        return fact instanceof Occurrence.Heard heard
                ? targetOf(table.ownStep(from, heard.event(), heard.holding()::contains), from)
                : from;
    }

    /** A device whose model has no step stays where it is. */
    private static State targetOf(@Nullable Step own, State from) {
        return own == null ? from : own.target();
    }
}
