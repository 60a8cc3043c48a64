/**
 * An evolution as text, JSON and pictures: the difference of two models, and its plan, with one line for each
 * transition of the new model in each reachable pair of states.
 *
 * <p>This package may use {@code statemachine}, {@code statechart}, {@code evolution} of the framework, and {@code
 * chart}, {@code diagram} and {@code format}. It does no I/O and makes no decisions; they come from the framework's
 * decision table.
 */
@NullMarked
package org.evoloop.models.evolution;

import org.jspecify.annotations.NullMarked;
