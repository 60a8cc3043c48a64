/**
 * A converter as a whole, and how it changes: one change at a time.
 *
 * <ul>
 *   <li>{@link org.evoloop.converter.changing.Converter}: what a {@code SystemEventConverter} hands its calls to; {@link
 *       org.evoloop.converter.changing.Delegates} provides it.
 *   <li>{@link org.evoloop.converter.changing.ChangeLock} and {@link org.evoloop.converter.changing.Stopping}: whose turn it
 *       is to change it, and how it stops without waiting for itself.
 *   <li>{@link org.evoloop.converter.changing.Construction}, {@link org.evoloop.converter.changing.ComponentChanges}, {@link
 *       org.evoloop.converter.changing.Spares} and {@link org.evoloop.converter.changing.Ownership}: its components, when it
 *       is built and later, and that no other converter has them.
 *   <li>{@link org.evoloop.converter.changing.Evolver} and {@link org.evoloop.converter.changing.ProbationWatch}: other models take
 *       over or run beside, and are on probation.
 * </ul>
 *
 * <p>No module exports this package. It may use {@code org.evoloop.converter.running} and what that uses.
 */
@NullMarked
package org.evoloop.converter.changing;

import org.jspecify.annotations.NullMarked;
