/**
 * Figures of running converters, by Micrometer: {@link org.evoloop.metrics.ConverterMetrics} for a registry of one's
 * own, and what the live page answers Prometheus.
 *
 * <p>This package may use {@code org.evoloop.converter}, what that uses, and {@code org.evoloop.page}.
 */
@NullMarked
package org.evoloop.metrics;

import org.jspecify.annotations.NullMarked;
