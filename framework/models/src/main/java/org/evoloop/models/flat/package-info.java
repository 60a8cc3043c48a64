/**
 * Flat machines as a table and as a file for Astah.
 *
 * <p>This package may use {@code statemachine} and {@code chart}. It does no I/O.
 */
@NullMarked
package org.evoloop.models.flat;

import org.jspecify.annotations.NullMarked;
