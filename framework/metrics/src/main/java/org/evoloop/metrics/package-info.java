/**
 * Metrics of running converters, with Micrometer: {@link org.evoloop.metrics.ConverterMetrics} for an application's own
 * registry, and the live page's document for Prometheus.
 *
 * <p>This package may use {@code org.evoloop.converter}, what that uses, and {@code org.evoloop.page}.
 */
@NullMarked
package org.evoloop.metrics;

import org.jspecify.annotations.NullMarked;
