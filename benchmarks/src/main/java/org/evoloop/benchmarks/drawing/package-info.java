/**
 * Pictures of the measurements, as SVG: our figures beside those of others, and a profile.
 *
 * <p>This package may use {@code org.evoloop.benchmarks.report} and {@code org.evoloop.benchmarks.profile}.
 */
@NullMarked
package org.evoloop.benchmarks.drawing;

import org.jspecify.annotations.NullMarked;
