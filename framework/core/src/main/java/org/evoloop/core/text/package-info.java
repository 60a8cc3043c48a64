/**
 * Snapshots of a core as text, to be kept in a file or sent elsewhere: readable, stable and versioned.
 *
 * <p>This package may use {@code org.evoloop.core}, {@code org.evoloop.evolution} and {@code org.evoloop.statemachine}. It makes
 * texts; files and streams are up to its users.
 */
@NullMarked
package org.evoloop.core.text;

import org.jspecify.annotations.NullMarked;
