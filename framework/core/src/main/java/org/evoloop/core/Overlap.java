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
    /** So much that the device did is kept; with more, nothing can be said of the order. */
    private static final int MOST = 32;

    private Overlap() {}

    /** Adds what the device did next. */
    static List<Occurrence> add(List<Occurrence> meanwhile, Occurrence fact) {
        if (meanwhile.size() == MOST) {
            return meanwhile;
        }
        List<Occurrence> more = new ArrayList<>(meanwhile);
        more.add(fact);
        return List.copyOf(more);
    }

    /**
     * Whether the device is in {@code end} in whatever order it happened.
     *
     * @param meanwhile in the order in which it happened, from where the step begins
     */
    static boolean alwaysEndsIn(State end, DecisionTable table, Step step, List<Occurrence> meanwhile) {
        State before = step.source();
        for (int place = 0; place <= meanwhile.size(); place++) {
            State state = takes(table, before, step);
            for (Occurrence fact : meanwhile.subList(place, meanwhile.size())) {
                state = follows(table, state, fact);
            }
            if (!state.equals(end)) {
                return false;
            }
            if (place < meanwhile.size()) {
                before = follows(table, before, meanwhile.get(place));
            }
        }
        return meanwhile.size() < MOST;
    }

    /** Where {@code step} takes the device if it is in {@code from} by then. */
    static State takes(DecisionTable table, State from, Step step) {
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
