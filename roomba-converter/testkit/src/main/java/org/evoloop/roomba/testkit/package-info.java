/**
 * For tests of programs that drive a Roomba: {@link org.evoloop.roomba.testkit.SimulatedRoombaExtension} gives each
 * test a simulated robot on a serial port. Linux only.
 *
 * <p>This package uses the simulator and JUnit 5.
 */
@NullMarked
package org.evoloop.roomba.testkit;

import org.jspecify.annotations.NullMarked;
