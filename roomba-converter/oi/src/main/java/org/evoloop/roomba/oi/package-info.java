/**
 * The iRobot Open Interface as pure bytes and values: commands to the robot, sensor packets and stream frames from it.
 * Figures are those of iRobot's "Create 2 Open Interface based on the Roomba 600" (2016), called the specification
 * here; where measured robots differ, the type says so. Both sides are here, since the simulated robot parses what the
 * application encodes and the other way round.
 *
 * <p>This package uses no other part of Evoloop, and no ports, threads or clocks.
 */
@NullMarked
package org.evoloop.roomba.oi;

import org.jspecify.annotations.NullMarked;
