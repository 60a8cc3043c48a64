/**
 * The new function of state Move: drive to the starting point. It is a MAPE-K loop of its own (paper, section VI.A):
 * monitor where the starting point is, analyze the course, plan wheel speeds, execute them.
 *
 * <p>The next action is decided in {@code phase}. This package may use that, {@code org.evoloop.roomba.session}, {@code
 * camera} and {@code oi}, and of the framework {@code loop}, {@code function} and their dependencies.
 */
@NullMarked
package org.evoloop.roomba.move;

import org.jspecify.annotations.NullMarked;
