/**
 * What a camera on the simulated robot sees: pictures in perspective of its room from its true pose, with what real
 * lenses and sensors add. The same room, pose, options and frame number give the same picture.
 *
 * <p>This package may use {@code simulator.room}.
 */
@NullMarked
package org.evoloop.roomba.simulator.eye;

import org.jspecify.annotations.NullMarked;
