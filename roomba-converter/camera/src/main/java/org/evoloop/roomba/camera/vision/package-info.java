/**
 * What the house asks of OpenCV, and how it is found: only whoever calls {@link
 * org.evoloop.roomba.camera.vision.OpenCv#vision} needs it on the machine.
 *
 * <p>This package may use {@code camera}.
 */
@NullMarked
package org.evoloop.roomba.camera.vision;

import org.jspecify.annotations.NullMarked;
