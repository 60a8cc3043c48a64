package org.evoloop.converter;

import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;

/**
 * What an occurrence was found to mean: what {@link EventAnalyze} hands to {@link EventPlan}.
 *
 * <p>Threading: immutable.
 *
 * @param occurrence the one that was analyzed
 * @param decision made in the states in which device and evolved system were then
 * @since 0.1
 */
public record Analysis(Occurrence occurrence, Decision decision) {}
