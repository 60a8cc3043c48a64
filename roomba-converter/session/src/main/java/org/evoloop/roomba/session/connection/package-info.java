/**
 * Connects to a robot and stays connected: opens links, wakes the robot, requests its stream, and starts again after a
 * loss.
 *
 * <p>This package may use {@code org.evoloop.roomba.oi}, {@code org.evoloop.link} and {@code org.evoloop.time}.
 */
@NullMarked
package org.evoloop.roomba.session.connection;

import org.jspecify.annotations.NullMarked;
