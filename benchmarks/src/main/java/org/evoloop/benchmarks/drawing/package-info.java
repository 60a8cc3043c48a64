/**
 * Pictures of what was measured, as SVG: the figures of a run beside those of others, and where a profile's time goes.
 *
 * <p>This room may use {@code org.evoloop.benchmarks.report} and {@code org.evoloop.benchmarks.profile}.
 */
@NullMarked
package org.evoloop.benchmarks.drawing;

import org.jspecify.annotations.NullMarked;
