package org.evoloop.converter;

import org.evoloop.loop.Plan;
import org.jspecify.annotations.Nullable;

/**
 * Turns an analysis into the list of events to send and at most one new function to start. A converter has one by
 * default; extend it to observe plans.
 *
 * @since 0.1
 */
public class EventPlan extends Plan<Analysis, ChangePlan> {
    /** A component named after its class. */
    public EventPlan() {}

    /** @param name its name in the console, unique within a converter */
    public EventPlan(String name) {
        super(name);
    }

    /** The plan; null if nothing is to be done. */
    @Override
    protected @Nullable ChangePlan plan(Analysis analysis) {
        return new ChangePlan(analysis.occurrence(), analysis.decision());
    }
}
