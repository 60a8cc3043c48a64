package org.evoloop.converter;

import static java.util.Objects.requireNonNull;

import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;

/**
 * The result of analyzing an occurrence, which {@link EventAnalyze} hands to {@link EventPlan}.
 *
 * <p>Threading: immutable.
 *
 * @param occurrence the analyzed occurrence
 * @param decision the decision, made for the states of device and evolved system at that moment
 * @since 0.1
 */
public record Analysis(Occurrence occurrence, Decision decision) {
    /** Neither may be null. */
    public Analysis {
        requireNonNull(occurrence, "the occurrence of an analysis is null");
        requireNonNull(decision, "the decision of an analysis is null");
    }
}
