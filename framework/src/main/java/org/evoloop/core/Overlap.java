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
    /** Where the device is if the step came before all of it, after the first of it, and so on to after all of it. */
    private final List<State> ends = new ArrayList<>();

    Overlap(DecisionTable table, Step step, List<Occurrence> meanwhile) {
        State before = step.source();
        for (int place = 0; place <= meanwhile.size(); place++) {
            State state = takes(table, before, step);
            for (Occurrence fact : meanwhile.subList(place, meanwhile.size())) {
                state = follows(table, state, fact);
            }
            ends.add(state);
            if (place < meanwhile.size()) {
                before = follows(table, before, meanwhile.get(place));
            }
        }
    }

    /** Where the device is by the order in which it was told: the step came last. */
    State asTold() {
        return ends.get(ends.size() - 1);
    }

    /** Whether that is so in whatever order it happened. */
    boolean isSure() {
        return ends.stream().allMatch(asTold()::equals);
    }

    private static State takes(DecisionTable table, State from, Step step) {
        return from.equals(step.source())
                ? step.target()
                : targetOf(table.ownStep(from, step.trigger(), guard -> false), from);
    }

    private static State follows(DecisionTable table, State from, Occurrence fact) {
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
