/**
 * The robot's camera as seen by other packages: what a camera is, which marker it looks for, and what it has seen.
 * {@code vision} defines what is needed of OpenCV and finds the library, {@code opencv} implements it, {@code live}
 * runs a camera, {@code tool} contains the commands.
 *
 * <p>Of other modules, these packages may only use {@code org.evoloop.time} and {@code natives}; this package uses
 * neither.
 */
@NullMarked
package org.evoloop.roomba.camera;

import org.jspecify.annotations.NullMarked;
