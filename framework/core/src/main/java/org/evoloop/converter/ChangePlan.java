package org.evoloop.converter;

import static java.util.Objects.requireNonNull;

import java.util.List;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/**
 * The plan for an occurrence, which {@link EventPlan} hands to the {@link EventExecute} components.
 *
 * <p>Threading: immutable.
 *
 * @param occurrence the occurrence that is converted
 * @param decision names the events to send, the effects to run and the state to enter
 * @since 0.1
 */
public record ChangePlan(Occurrence occurrence, Decision decision) {
    /** Neither may be null. */
    public ChangePlan {
        requireNonNull(occurrence, "the occurrence of a plan is null");
        requireNonNull(decision, "the decision of a plan is null");
    }

    /** The steps to send to the device, in order. */
    public List<Step> steps() {
        return decision.steps();
    }

    /**
     * An analyze component may have made the decision: the record must not come to states that do not exist, or that its
     * steps and its transition do not lead to, and a journal must be readable by the models.
     *
     * @throws IllegalStateException if it leads to a state, or takes a transition, that {@code models} do not have, or
     *     does not lead there
     */
    void requireDrawnIn(ModelPair models) {
        requireStates(models, decision.before());
        requireStates(models, decision.after());
        Transition taken = decision.transition();
        if (taken != null) {
            requireTransition(models.evolved(), taken, "new");
        }
        for (Step step : steps()) {
            requireTransition(models.original(), step.transition(), "original");
        }
        requireLeadsToItsEnd(models);
    }

    private void requireLeadsToItsEnd(ModelPair models) {
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
        for (Step step : steps()) {
            // A step from elsewhere leads nowhere; the device stays where it is.
            reached = step.source().equals(reached) ? step.target() : reached;
        }
        if (!reached.equals(end.original())) {
            throw new IllegalStateException("the plan leads the device from " + begin.original() + " to "
                    + end.original() + ", but its steps " + steps() + " lead to " + reached);
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
