package org.evoloop.converter;

import org.evoloop.converter.attachment.DecisionHost;
import org.evoloop.converter.attachment.Friends;
import org.evoloop.loop.Plan;
import org.jspecify.annotations.Nullable;

/**
 * Turns an analysis into the list of events to send and at most one new function to start. A converter has one by
 * default; extend it to observe plans.
 *
 * @since 0.1
 */
public class EventPlan extends Plan<Analysis, ChangePlan> {
    static {
        Friends.PLAN.give(plan -> ((EventPlan) plan)::attach);
    }

    private volatile @Nullable DecisionHost host;

    /** A component named after its class. */
    public EventPlan() {}

    /** @param name its name in the console, unique within a converter */
    public EventPlan(String name) {
        super(name);
    }

    private void attach(DecisionHost joined) {
        host = joined;
    }

    /**
     * The plan; null if nothing is to be done. An override may return null to dismiss an occurrence, except for those
     * that {@link EventAnalyze} cannot refuse.
     */
    @Override
    protected @Nullable ChangePlan plan(Analysis analysis) {
        return planned(analysis);
    }

    private static ChangePlan planned(Analysis analysis) {
        return new ChangePlan(analysis.occurrence(), analysis.decision());
    }

    /** The usual plan for what keeps the record right; null for any other occurrence. */
    @Override
    protected final @Nullable ChangePlan unlessDismissed(Analysis analysis) {
        DecisionHost attached = host;
        return attached != null && attached.keepsRecord(analysis.occurrence()) ? planned(analysis) : null;
    }
}
