/**
 * The simulated robot as the Open Interface shows it: modes and what the robot does by itself, buttons, sensor values,
 * replies and streams. {@link org.evoloop.roomba.simulator.robot.SimulatedRoomba} is the whole robot: it receives
 * and sends bytes, and its time passes only by calls.
 *
 * <p>This package may use {@code oi}, {@code simulator.behavior} and {@code simulator.body}. It knows no ports, threads or
 * clocks.
 */
@NullMarked
package org.evoloop.roomba.simulator.robot;

import org.jspecify.annotations.NullMarked;
