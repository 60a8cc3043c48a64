/**
 * The simulated robot's hardware: wheels on a floor, motors that draw current, a battery, a bumper and sensors. It does
 * not depend on the Open Interface, and advances in steps of 15 ms.
 *
 * <p>This package may use {@code simulator.room}.
 */
@NullMarked
package org.evoloop.roomba.simulator.body;

import org.jspecify.annotations.NullMarked;
