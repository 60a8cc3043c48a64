/**
 * A running camera: the thread that reads frames, the thread that processes them, what they exchange, and the camera's
 * condition.
 *
 * <p>This package may use {@code camera}, {@code camera.vision}, {@code natives} and {@code org.evoloop.time}.
 */
@NullMarked
package org.evoloop.roomba.camera.live;

import org.jspecify.annotations.NullMarked;
