/**
 * The converter as one deterministic object: everything between its inputs and its outputs. The same inputs on the same
 * state give the same outputs and the same next state, so that it can be saved, restored, replayed and explored.
 *
 * <p>This package may use {@code org.evoloop.evolution} and {@code org.evoloop.statemachine}. It knows no threads,
 * clocks, files, logs or random numbers: time comes in with the inputs.
 */
@NullMarked
package org.evoloop.engine;

import org.jspecify.annotations.NullMarked;
