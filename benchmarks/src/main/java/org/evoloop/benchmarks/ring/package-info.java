/**
 * The whole loop with a thread a component, beside bare rings of threads that hand one object round: one event after
 * the other, and in a flood.
 *
 * <p>This room may use the framework, {@code org.evoloop.benchmarks.report} and the plain and the flooded loop
 * of {@code org.evoloop.benchmarks.running}.
 */
@NullMarked
package org.evoloop.benchmarks.ring;

import org.jspecify.annotations.NullMarked;
