/**
 * Gets a robot on the line and keeps it there: opens links, wakes the robot, asks for its stream, and begins anew when
 * it was lost.
 *
 * <p>This room may use {@code org.evoloop.roomba.oi}, {@code org.evoloop.link} and {@code org.evoloop.time}.
 */
@NullMarked
package org.evoloop.roomba.session.connection;

import org.jspecify.annotations.NullMarked;
