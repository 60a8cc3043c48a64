package org.evoloop.converter;

import static java.util.Objects.requireNonNull;

import java.util.List;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;

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
}
