/**
 * The floor plan around the simulated robot: walls, obstacles, cliffs and the dock, as plane geometry, and the text
 * file that describes them. The robot is treated as a disc.
 *
 * <p>This package uses no other part of Evoloop.
 */
@NullMarked
package org.evoloop.roomba.simulator.room;

import org.jspecify.annotations.NullMarked;
