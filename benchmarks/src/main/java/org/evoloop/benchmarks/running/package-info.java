/**
 * How the loop and a whole converter run: in steps, flooded, with threads, idle, and beside a camera.
 *
 * <p>This package may use the framework, {@code org.evoloop.benchmarks.profile}, {@code org.evoloop.benchmarks.report},
 * and of the Roomba converter its camera and the simulated robot.
 */
@NullMarked
package org.evoloop.benchmarks.running;

import org.jspecify.annotations.NullMarked;
