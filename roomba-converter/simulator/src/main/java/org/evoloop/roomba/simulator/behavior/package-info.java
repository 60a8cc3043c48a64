/**
 * The simulated robot's own activities: spot cleaning, cleaning, seeking the dock. The patterns follow descriptions by
 * users; iRobot's programs are not public.
 *
 * <p>This package may use {@code simulator.body} and {@code simulator.room}.
 */
@NullMarked
package org.evoloop.roomba.simulator.behavior;

import org.jspecify.annotations.NullMarked;
