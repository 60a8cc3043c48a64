/**
 * The whole loop with a thread per component, compared with bare rings of threads that pass one object round: one event
 * at a time, and in a flood.
 *
 * <p>This package may use the framework, {@code org.evoloop.benchmarks.report} and the plain and the flooded loop of
 * {@code org.evoloop.benchmarks.running}.
 */
@NullMarked
package org.evoloop.benchmarks.ring;

import org.jspecify.annotations.NullMarked;
