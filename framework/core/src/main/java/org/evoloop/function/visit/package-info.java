/**
 * How a converter runs the visits of its states and their functions; no concern of those who write a function.
 *
 * <p>This package may use {@code org.evoloop.function}, {@code org.evoloop.time} and {@code org.evoloop.statemachine}. The
 * module does not export it.
 */
@NullMarked
package org.evoloop.function.visit;

import org.jspecify.annotations.NullMarked;
