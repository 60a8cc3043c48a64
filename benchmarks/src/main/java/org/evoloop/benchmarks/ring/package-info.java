/**
 * The whole loop with a thread a component, beside bare rings of four threads that hand one object round.
 *
 * <p>This room may use the framework and {@code org.evoloop.benchmarks}' rows.
 */
@NullMarked
package org.evoloop.benchmarks.ring;

import org.jspecify.annotations.NullMarked;
