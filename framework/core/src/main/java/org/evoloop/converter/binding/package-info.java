/**
 * The code that knowledge binds to the guards and effects of models, and the costs of paths: {@link
 * org.evoloop.converter.binding.Bindings}. {@link org.evoloop.converter.binding.GuardWatch} counts a guard's failures, and
 * keeps threads away from one that hangs.
 *
 * <p>No module exports this package. It may use {@code org.evoloop.loop}, {@code evolution}, {@code time} and {@code
 * statemachine}.
 */
@NullMarked
package org.evoloop.converter.binding;

import org.jspecify.annotations.NullMarked;
