/**
 * Properties of an evolution in temporal logic (CTL), written beside the models in words and checked by M3C of
 * AutomataLib over every moment that can be reached. {@link org.evoloop.models.temporal.PropertyCheck} is the way in.
 *
 * <p>This room may use {@code statemachine} and {@code evolution} of the framework. It reads no files.
 */
@NullMarked
package org.evoloop.models.temporal;

import org.jspecify.annotations.NullMarked;
