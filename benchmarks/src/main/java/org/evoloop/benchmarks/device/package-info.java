/**
 * The Roomba converter as it is used: with a robot behind a pseudo-terminal, and as a separate program.
 *
 * <p>This package may use the Roomba converter, the framework and {@code org.evoloop.benchmarks.report}.
 */
@NullMarked
package org.evoloop.benchmarks.device;

import org.jspecify.annotations.NullMarked;
