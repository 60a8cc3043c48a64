/**
 * Pictures of what the simulated robot did: where it went in its room and why, as one SVG file for people to look at.
 *
 * <p>This package may use {@code oi}, {@code simulator.robot} and {@code simulator.room}. It writes no files itself.
 */
@NullMarked
package org.evoloop.roomba.simulator.drawing;

import org.jspecify.annotations.NullMarked;
