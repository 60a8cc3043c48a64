package org.evoloop.converter;

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
public record Analysis(Occurrence occurrence, Decision decision) {}
