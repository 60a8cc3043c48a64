/**
 * Shared by all output formats: flat machines as charts, unique names for the elements of a chart, and the labels of
 * transitions.
 *
 * <p>This package may use {@code statemachine} and {@code statechart}. It does no I/O.
 */
@NullMarked
package org.evoloop.models.chart;

import org.jspecify.annotations.NullMarked;
