/**
 * What the program needs of OpenCV, and how the library is found. Only callers of {@link
 * org.evoloop.roomba.camera.vision.OpenCv#vision} need it to be installed.
 *
 * <p>This package may use {@code camera}.
 */
@NullMarked
package org.evoloop.roomba.camera.vision;

import org.jspecify.annotations.NullMarked;
