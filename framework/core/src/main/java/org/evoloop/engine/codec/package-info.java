/**
 * Snapshots of a core as text, to be stored in a file or sent elsewhere: readable, stable and versioned.
 *
 * <p>This package may use {@code org.evoloop.engine}, {@code org.evoloop.evolution} and {@code org.evoloop.statemachine}.
 * It produces text only; files and streams are up to its users.
 */
@NullMarked
package org.evoloop.engine.codec;

import org.jspecify.annotations.NullMarked;
