/**
 * The floor plan that the simulated robot lives in: walls, obstacles, cliffs and the dock, as plane geometry, and the
 * text file that describes them. It knows nothing of the robot but that it is a disc.
 *
 * <p>This package uses no other part of Evoloop.
 */
@NullMarked
package org.evoloop.roomba.simulator.room;

import org.jspecify.annotations.NullMarked;
