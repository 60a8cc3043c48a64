/**
 * How bytes travel between the converter and the robot: a serial port, or memory for tests, and the line that wakes a
 * sleeping robot. What the bytes mean is no business of this room.
 *
 * <p>This room may use {@code org.evoloop.roomba.oi} and {@code natives}.
 */
@NullMarked
package org.evoloop.roomba.link;

import org.jspecify.annotations.NullMarked;
