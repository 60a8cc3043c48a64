package org.evoloop.engine;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * A step that was being sent while the device acted by itself: the order of the device's actions is known, but not
 * which of them came before the step's effect and which after.
 */
final class Overlap {
    /** How many of the device's actions are kept; with more, the order is taken to be unknown. */
    private static final int MOST = 32;

    private Overlap() {}

    /** Adds the device's next action. */
    static List<Occurrence> add(List<Occurrence> meanwhile, Occurrence fact) {
        if (meanwhile.size() == MOST) {
            return meanwhile;
        }
        List<Occurrence> more = new ArrayList<>(meanwhile);
        more.add(fact);
        return List.copyOf(more);
    }

    /**
     * Whether the device ends in {@code end} for every possible order.
     *
     * @param meanwhile the device's actions in their order, from the step's source on
     */
    static boolean alwaysEndsIn(State end, DecisionTable table, Step step, List<Occurrence> meanwhile) {
        State before = step.source();
        for (int place = 0; place <= meanwhile.size(); place++) {
            if (isGuarded(table, before, step)) {
                return false;
            }
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

    /**
     * One of {@code meanwhile} that the device cannot have done, whatever the order; null if there is an order in which it
     * can have done everything.
     *
     * @param step the step that it took as well; null if it took none
     * @param stepLast whether it is known to have taken the step last
     */
    static @Nullable Occurrence impossible(
            DecisionTable table, State start, @Nullable Step step, List<Occurrence> meanwhile, boolean stepLast) {
        Occurrence found = null;
        for (int place = step == null || stepLast ? meanwhile.size() : 0; place <= meanwhile.size(); place++) {
            found = impossible(table, start, step, meanwhile, place);
            if (found == null) {
                return null;
            }
        }
        return found;
    }

    /** @param place before which of {@code meanwhile} the device took the step */
    private static @Nullable Occurrence impossible(
            DecisionTable table, State start, @Nullable Step step, List<Occurrence> meanwhile, int place) {
        State at = start;
        for (int index = 0; index < meanwhile.size(); index++) {
            Occurrence fact = meanwhile.get(index);
            at = index == place && step != null ? takes(table, at, step) : at;
            if (isImpossible(table, at, fact)) {
                return fact;
            }
            at = follows(table, at, fact);
        }
        return null;
    }

    private static boolean isImpossible(DecisionTable table, State at, Occurrence fact) {
        return fact instanceof Occurrence.Heard heard && table.isImpossible(at, heard.event());
    }

    /**
     * Whether guards decide where {@code step} takes the device from {@code from}. In another state than the step's
     * source, nobody has evaluated them.
     */
    static boolean isGuarded(DecisionTable table, State from, Step step) {
        return !from.equals(step.source()) && table.isGuarded(from, step.trigger());
    }

    /** The state to which {@code step} takes the device from {@code from}; if that is guarded, no guard holds. */
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

    /** Without a step in its model, the device stays where it is. */
    private static State targetOf(@Nullable Step own, State from) {
        return own == null ? from : own.target();
    }
}
