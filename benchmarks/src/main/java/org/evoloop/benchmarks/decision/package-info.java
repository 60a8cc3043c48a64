/**
 * What one decision costs: ours beside the state machine libraries that people use, on the same machines.
 *
 * <p>This room may use the framework, the libraries, {@code org.evoloop.benchmarks.report} and {@code
 * org.evoloop.benchmarks.profile}.
 */
@NullMarked
package org.evoloop.benchmarks.decision;

import org.jspecify.annotations.NullMarked;
