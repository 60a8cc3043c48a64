package org.evoloop.converter;

import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.loop.Analyze;
import org.jspecify.annotations.Nullable;

/**
 * Finds out what an event means in the current states: not acceptable, an existing function, or a new function. A
 * converter has one without being told; extend it to watch or to refine decisions.
 */
public class DecisionAnalyze extends Analyze<Occurrence, Decision> {
    private volatile @Nullable ConverterCore core;

    /** A component that is called like its class. */
    public DecisionAnalyze() {}

    void attach(ConverterCore converterCore) {
        core = converterCore;
    }

    /**
     * The decision; null for an event that means nothing any more: it was raised during an earlier visit of a state, or
     * given up because this component did not return in time.
     */
    @Override
    protected @Nullable Decision analyze(Occurrence occurrence) {
        ConverterCore attached = core;
        return attached == null || !attached.loop.hasTurn(this) ? null : attached.decide(occurrence);
    }
}
