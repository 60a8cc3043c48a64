package org.evoloop.converter;

import java.util.List;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;

/**
 * What is to be done about an occurrence: what {@link EventPlan} hands to the {@link EventExecute} components.
 *
 * <p>Threading: immutable.
 *
 * @param occurrence the one that is converted
 * @param decision what it means; it names the events to send, the effects to run and the state to enter
 * @since 0.1
 */
public record ChangePlan(Occurrence occurrence, Decision decision) {

    /** The steps that take the device on, in order. */
    public List<Step> steps() {
        return decision.steps();
    }
}
