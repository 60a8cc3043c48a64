/**
 * The simulated robot as a thing: wheels on a floor, motors that draw current, a battery, a bumper and eyes. It knows
 * nothing of the Open Interface and does what it is told, 15 ms at a time.
 *
 * <p>This package may use {@code simulator.room}.
 */
@NullMarked
package org.evoloop.roomba.simulator.body;

import org.jspecify.annotations.NullMarked;
