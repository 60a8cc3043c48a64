/**
 * How a converter runs the visits of its states and their functions; authors of functions do not need it.
 *
 * <p>This package may use {@code org.evoloop.function} and what that uses.
 * The module does not export it.
 */
@NullMarked
package org.evoloop.function.visit;

import org.jspecify.annotations.NullMarked;
