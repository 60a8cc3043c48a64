/**
 * The whole loop with a thread a component, beside bare rings of four threads that hand one object round.
 *
 * <p>This room may use the framework, {@code org.evoloop.benchmarks.report} and the plain loop of {@code
 * org.evoloop.benchmarks.running}.
 */
@NullMarked
package org.evoloop.benchmarks.ring;

import org.jspecify.annotations.NullMarked;
