package org.evoloop.converter.running;

import java.util.List;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/**
 * Checks a decision that an analyze component may have made: the record must not come to states that do not exist, or that
 * its steps and its transition do not lead to, and a journal must be readable by the models.
 */
final class PlanCheck {
    private PlanCheck() {}

    /**
     * Refuses a decision that cannot be carried out.
     *
     * @throws IllegalStateException if it leads to a state, or takes a transition, that {@code models} do not have, or
     *     does not lead there
     */
    static void requireDrawnIn(ModelPair models, Decision decision) {
        requireStates(models, decision.before());
        requireStates(models, decision.after());
        Transition taken = decision.transition();
        if (taken != null) {
            requireTransition(models.evolved(), taken, "new");
        }
        for (Step step : decision.steps()) {
            requireTransition(models.original(), step.transition(), "original");
        }
        requireLeadsToItsEnd(models, decision);
    }

    private static void requireLeadsToItsEnd(ModelPair models, Decision decision) {
        Configuration begin = decision.before();
        Configuration end = decision.after();
        Transition taken = decision.leavesState() ? decision.transition() : null;
        State left = taken == null ? begin.evolved() : taken.source();
        State entered = taken == null ? begin.evolved() : taken.target();
        if (!left.equals(begin.evolved()) || !entered.equals(end.evolved())) {
            throw new IllegalStateException("the plan leads the new model from " + begin.evolved() + " to "
                    + end.evolved() + (taken == null ? ", but takes no transition" : ", but takes " + taken));
        }
        State reached = begin.original();
        for (Step step : decision.steps()) {
            // A step from elsewhere leads nowhere; the device stays where it is.
            reached = step.source().equals(reached) ? step.target() : reached;
        }
        if (!reached.equals(end.original())) {
            throw new IllegalStateException("the plan leads the device from " + begin.original() + " to "
                    + end.original() + ", but its steps " + decision.steps() + " lead to " + reached);
        }
        List<State> needed = taken == null ? List.of() : models.whereDeviceMustBe(entered);
        if (!needed.isEmpty() && !needed.contains(reached)) {
            throw new IllegalStateException(
                    "the plan leads the new model to " + entered + " and leaves the device in " + reached);
        }
    }

    private static void requireStates(ModelPair models, Configuration at) {
        requireState(models.evolved(), at.evolved(), "new");
        requireState(models.original(), at.original(), "original");
    }

    private static void requireState(StateMachine machine, State state, String which) {
        if (!machine.hasState(state)) {
            throw new IllegalStateException("the plan leads to " + state + ", which is not a state of the " + which
                    + " model" + Names.hint(state.name(), machine.states()));
        }
    }

    private static void requireTransition(StateMachine machine, Transition taken, String which) {
        Transition drawn = machine.transition(taken.source(), taken.event()).orElse(null);
        if (!taken.equals(drawn)) {
            throw new IllegalStateException("the plan takes " + taken + ", which is not a transition of the " + which
                    + " model; take one of those that are drawn there");
        }
    }
}
