/**
 * The simulated robot as the Open Interface shows it: modes and what the robot does by itself, buttons, sensor values,
 * replies and streams. {@link org.evoloop.roomba.simulator.robot.SimulatedRoomba} is the whole of it; bytes go in and
 * come out, and time passes when it is told to.
 *
 * <p>This package may use {@code oi}, {@code simulator.behavior} and {@code simulator.body}. It knows no ports, threads or
 * clocks.
 */
@NullMarked
package org.evoloop.roomba.simulator.robot;

import org.jspecify.annotations.NullMarked;
