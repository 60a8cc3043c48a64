/**
 * The robot behind the cable: a session keeps the stream of sensor values going and makes sense of it (buttons, where
 * the robot is, when a spot cleaning has ended), and sends commands.
 *
 * <p>This room may use {@code org.evoloop.roomba.oi}, {@code org.evoloop.link}, {@code org.evoloop.time} and
 * {@code org.evoloop.converter.DeviceLink}. What can be made out from frames alone is made out in {@code inference};
 * the cable is the affair of {@code connection}.
 */
@NullMarked
package org.evoloop.roomba.session;

import org.jspecify.annotations.NullMarked;
