/**
 * Flat machines for people and for other tools.
 *
 * <p>This room may use {@code statemachine} and {@code chart}. It is pure.
 */
@NullMarked
package org.evoloop.models.flat;

import org.jspecify.annotations.NullMarked;
