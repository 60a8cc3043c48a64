/**
 * What one decision costs: ours beside the state machine libraries that people use, on the same machines.
 *
 * <p>This room may use the framework, the libraries, and {@code org.evoloop.benchmarks}' rows.
 */
@NullMarked
package org.evoloop.benchmarks.decision;

import org.jspecify.annotations.NullMarked;
