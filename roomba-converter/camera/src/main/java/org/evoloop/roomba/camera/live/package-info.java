/**
 * A camera at work: the thread that reads it, the thread that looks, what they pass on, and what state the camera is
 * in.
 *
 * <p>This package may use {@code camera}, {@code camera.vision}, {@code natives} and {@code org.evoloop.time}.
 */
@NullMarked
package org.evoloop.roomba.camera.live;

import org.jspecify.annotations.NullMarked;
