/**
 * Finds out what other models would have decided: gives the same events to a core whose directives are not carried out.
 * {@link org.evoloop.rehearsal.Comparison} compares both, event by event; a {@link org.evoloop.rehearsal.Difference} has the
 * {@link org.evoloop.rehearsal.Verdict} of each.
 *
 * <p>This package may use {@code org.evoloop.engine}, {@code engine.codec}, {@code evolution} and {@code statemachine}.
 */
@NullMarked
package org.evoloop.rehearsal;

import org.jspecify.annotations.NullMarked;
