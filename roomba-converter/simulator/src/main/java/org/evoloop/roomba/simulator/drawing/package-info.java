/**
 * Drawings of the simulated robot's path in its room, with the causes of its movements, as one SVG file for people.
 *
 * <p>This package may use {@code oi}, {@code simulator.robot} and {@code simulator.room}. It writes no files itself.
 */
@NullMarked
package org.evoloop.roomba.simulator.drawing;

import org.jspecify.annotations.NullMarked;
