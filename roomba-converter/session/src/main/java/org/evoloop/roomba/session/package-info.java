/**
 * A connected robot: a session maintains the stream of sensor values, interprets it (buttons, the robot's position, the
 * end of a spot cleaning), and sends commands.
 *
 * <p>This package may use {@code org.evoloop.roomba.oi}, {@code org.evoloop.link}, {@code org.evoloop.time} and
 * {@code org.evoloop.converter.DeviceLink}. Conclusions from frames alone are drawn in {@code inference};
 * the link is managed by {@code connection}.
 */
@NullMarked
package org.evoloop.roomba.session;

import org.jspecify.annotations.NullMarked;
