/**
 * What the simulated robot does by itself: spot cleaning, cleaning, seeking the dock. The patterns are those that
 * people describe; iRobot's own programs are not public.
 *
 * <p>This package may use {@code simulator.body} and {@code simulator.room}.
 */
@NullMarked
package org.evoloop.roomba.simulator.behavior;

import org.jspecify.annotations.NullMarked;
