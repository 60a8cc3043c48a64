/**
 * What a camera on the simulated robot sees: perspective pictures of its room from its true pose, with the effects of
 * real lenses and sensors. The same room, pose, options and frame number give the same picture.
 *
 * <p>This package may use {@code simulator.room}.
 */
@NullMarked
package org.evoloop.roomba.simulator.eye;

import org.jspecify.annotations.NullMarked;
