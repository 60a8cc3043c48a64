/**
 * Properties of an evolution, checked by M3C of AutomataLib over every moment that can be reached; the language is
 * {@code org.evoloop.check.temporal}'s. {@link org.evoloop.models.temporal.PropertyCheck} is the way in.
 *
 * <p>This room may use {@code statemachine}, {@code evolution} and {@code check} of the framework. It reads no files.
 */
@NullMarked
package org.evoloop.models.temporal;

import org.jspecify.annotations.NullMarked;
