/**
 * New functions: what runs on this computer while the evolved system is in a state that the device does not have
 * (paper, section V.B). A function is a single class, a composite of sub-states, or a control loop of its own.
 *
 * <p>This package may use {@code org.evoloop.evolution} for the values of events, {@code loop}, {@code time} and {@code
 * statemachine}; it knows nothing of decisions.
 */
@NullMarked
package org.evoloop.function;

import org.jspecify.annotations.NullMarked;
