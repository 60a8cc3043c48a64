/**
 * What an evolution is, for people and for programs: the difference of two models, and its plan, a line for each
 * transition of the new model in each pair of states that can be reached.
 *
 * <p>This room may use {@code statemachine}, {@code statechart}, {@code evolution} of the framework, and {@code chart},
 * {@code diagram} and {@code format}. It is pure, and decides nothing: decisions come from the framework's table.
 */
@NullMarked
package org.evoloop.models.evolution;

import org.jspecify.annotations.NullMarked;
