package org.evoloop.converter;

import org.evoloop.evolution.Decision;
import org.evoloop.loop.Plan;
import org.jspecify.annotations.Nullable;

/**
 * Turns a decision into the list of events to send and at most one new function to start. A converter has one without
 * being told; extend it to watch plans.
 */
public class DecisionPlan extends Plan<Decision, Conversion> {
    private @Nullable ConverterCore core;

    /** A component that is called like its class. */
    public DecisionPlan() {}

    void attach(ConverterCore converterCore) {
        core = converterCore;
    }

    @Override
    protected @Nullable Conversion plan(Decision decision) {
        return core == null ? null : core.plan(decision);
    }
}
