package org.evoloop.converter;

import java.util.List;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

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

    /** The steps to send to the device, in order. */
    public List<Step> steps() {
        return decision.steps();
    }

    /**
     * An analyze component may have made the decision: the record must not come to states that do not exist.
     *
     * @throws IllegalStateException if it leads to a state that {@code models} do not have
     */
    void requireStatesOf(ModelPair models) {
        requireState(models.evolved(), decision.after().evolved(), "new");
        requireState(models.original(), decision.after().original(), "original");
        for (int index = 0; index < steps().size(); index++) {
            requireState(models.original(), steps().get(index).target(), "original");
        }
    }

    private static void requireState(StateMachine machine, State state, String which) {
        if (!machine.hasState(state)) {
            throw new IllegalStateException("the plan leads to " + state + ", which is not a state of the " + which
                    + " model" + Names.hint(state.name(), machine.states()));
        }
    }
}
