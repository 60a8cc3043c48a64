/**
 * The cost of one decision: ours compared with popular state machine libraries, on the same machines.
 *
 * <p>This package may use the framework, the libraries, {@code org.evoloop.benchmarks.report} and {@code
 * org.evoloop.benchmarks.profile}.
 */
@NullMarked
package org.evoloop.benchmarks.decision;

import org.jspecify.annotations.NullMarked;
