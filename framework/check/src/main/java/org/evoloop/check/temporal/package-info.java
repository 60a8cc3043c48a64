/**
 * Properties that an evolution must satisfy, in temporal logic, written in words beside the models ({@link
 * org.evoloop.check.properties.PropertyFile}), over moments of a converter ({@link org.evoloop.check.temporal.Moment}).
 * {@link org.evoloop.check.temporal.PropertyWatch} evaluates what has happened, {@link
 * org.evoloop.check.temporal.Outlook} what can happen according to the models.
 *
 * <p>This package may use {@code org.evoloop.check}, {@code core}, {@code evolution} and {@code statemachine}. It reads
 * no files.
 */
@NullMarked
package org.evoloop.check.temporal;

import org.jspecify.annotations.NullMarked;
