/**
 * What it costs to read models, to start, and to carry the framework along.
 *
 * <p>This room may use the framework and {@code org.evoloop.benchmarks.report}.
 */
@NullMarked
package org.evoloop.benchmarks.loading;

import org.jspecify.annotations.NullMarked;
