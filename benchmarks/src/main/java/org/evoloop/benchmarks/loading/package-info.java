/**
 * The cost of reading models, of starting, and of depending on the framework.
 *
 * <p>This package may use the framework and {@code org.evoloop.benchmarks.report}.
 */
@NullMarked
package org.evoloop.benchmarks.loading;

import org.jspecify.annotations.NullMarked;
