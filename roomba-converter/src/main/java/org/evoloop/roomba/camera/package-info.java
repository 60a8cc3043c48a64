/**
 * The robot's eye: where frames come from, what state the camera is in, and where the starting point's marker is seen.
 * Nothing here needs OpenCV to be loaded; the classes that do are in {@code opencv}, behind {@link
 * org.evoloop.roomba.camera.MarkerCamera}.
 *
 * <p>This room may use nothing of the other rooms but {@code org.evoloop.time}.
 */
@NullMarked
package org.evoloop.roomba.camera;

import org.jspecify.annotations.NullMarked;
