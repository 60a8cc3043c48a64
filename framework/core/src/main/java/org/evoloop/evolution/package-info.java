/**
 * The evolution of a device: the pair of its original and its new state machine model, and every decision about it as
 * pure functions (paper, sections IV and V). All callers share them: the running loop looks decisions up in the {@link
 * org.evoloop.evolution.DecisionTable}, and the checks at design time read the same table's problems.
 *
 * <p>This package may use {@code org.evoloop.statemachine} only. It knows no threads, clocks or files.
 */
@NullMarked
package org.evoloop.evolution;

import org.jspecify.annotations.NullMarked;
