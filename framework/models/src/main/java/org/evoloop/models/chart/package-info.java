/**
 * What every way of showing a machine needs: flat machines as charts, names that tell all parts of a chart apart, and
 * the labels of transitions.
 *
 * <p>This room may use {@code statemachine} and {@code statechart}. It is pure.
 */
@NullMarked
package org.evoloop.models.chart;

import org.jspecify.annotations.NullMarked;
