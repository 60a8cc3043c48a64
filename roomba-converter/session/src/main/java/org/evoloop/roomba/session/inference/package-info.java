/**
 * Infers the robot's activity from its frames: pressed buttons, running and resting motors, the end of a spot cleaning.
 * Pure: frames in, results out, and time is counted in frames.
 *
 * <p>This package may use {@code org.evoloop.roomba.oi}.
 */
@NullMarked
package org.evoloop.roomba.session.inference;

import org.jspecify.annotations.NullMarked;
