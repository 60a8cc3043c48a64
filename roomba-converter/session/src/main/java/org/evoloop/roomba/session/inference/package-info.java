/**
 * What a robot does, made out from what its frames show: pressed buttons, motors at work and at rest, the end of a spot
 * cleaning. Pure: frames in, findings out, and time is counted in frames.
 *
 * <p>This room may use {@code org.evoloop.roomba.oi}.
 */
@NullMarked
package org.evoloop.roomba.session.inference;

import org.jspecify.annotations.NullMarked;
