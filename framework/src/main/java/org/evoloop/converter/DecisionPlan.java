package org.evoloop.converter;

import org.evoloop.evolution.Decision;
import org.evoloop.loop.Plan;
import org.jspecify.annotations.Nullable;

/**
 * Turns a decision into the list of events to send and at most one new function to start. A converter has one without
 * being told; extend it to watch plans.
 */
public class DecisionPlan extends Plan<Decision, Conversion> {
    private volatile @Nullable ConverterCore core;

    /** A component that is called like its class. */
    public DecisionPlan() {}

    void attach(ConverterCore converterCore) {
        core = converterCore;
    }

    /** The plan; null for a decision that was given up because this component did not return in time. */
    @Override
    protected @Nullable Conversion plan(Decision decision) {
        ConverterCore attached = core;
        return attached == null || !attached.loop.hasTurn(this) ? null : attached.plan(decision);
    }
}
