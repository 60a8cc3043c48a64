/**
 * How the loop and a whole converter run: in steps, flooded, with threads, and idle.
 *
 * <p>This room may use the framework, the simulated Roomba, {@code org.evoloop.benchmarks.profile} and {@code
 * org.evoloop.benchmarks.report}.
 */
@NullMarked
package org.evoloop.benchmarks.running;

import org.jspecify.annotations.NullMarked;
