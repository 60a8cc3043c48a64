/**
 * Checks the properties of an evolution with M3C of AutomataLib over every reachable moment. The language of properties
 * belongs to {@code org.evoloop.check.temporal}. The entry point is {@link org.evoloop.models.temporal.PropertyCheck}.
 *
 * <p>This package may use {@code statemachine}, {@code evolution} and {@code check} of the framework. It reads no
 * files.
 */
@NullMarked
package org.evoloop.models.temporal;

import org.jspecify.annotations.NullMarked;
