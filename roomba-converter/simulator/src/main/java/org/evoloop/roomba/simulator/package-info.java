/**
 * The simulated Roomba as a program: the pseudo-terminal through which any program can talk to it as if it were a
 * serial port, the thread that lets its time pass, and the text commands by which people press its buttons, carry it
 * and pull its cables.
 *
 * <p>This package may use {@code org.evoloop.roomba.oi}, {@code org.evoloop.natives}, {@code org.evoloop.time} and the rooms
 * below it. It never uses the converter, so that it stays an honest opponent.
 */
@NullMarked
package org.evoloop.roomba.simulator;

import org.jspecify.annotations.NullMarked;
