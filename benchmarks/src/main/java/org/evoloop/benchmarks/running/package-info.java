/**
 * How the loop and a whole converter run: in steps, flooded, with threads, idle, and beside a camera.
 *
 * <p>This room may use the framework, {@code org.evoloop.benchmarks.report}, and of the Roomba converter its camera and the
 * simulator that draws pictures.
 */
@NullMarked
package org.evoloop.benchmarks.running;

import org.jspecify.annotations.NullMarked;
