/**
 * The simulated Roomba and the pseudo-terminal through which any program can talk to it as if it were a serial port.
 *
 * <p>This room may use {@code org.evoloop.roomba.oi}. It never uses the converter, so that it stays an honest opponent.
 */
@NullMarked
package org.evoloop.roomba.simulator;

import org.jspecify.annotations.NullMarked;
