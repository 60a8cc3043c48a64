/**
 * The robot's eye, as the rest of the house knows it: what a camera is, what marker it looks for, what it has seen.
 * {@code vision} says what is asked of OpenCV and finds it, {@code opencv} does it, {@code live} is a camera at work,
 * {@code tool} has the commands.
 *
 * <p>These rooms may use nothing of the others but {@code org.evoloop.time} and {@code natives}; this one uses nothing.
 */
@NullMarked
package org.evoloop.roomba.camera;

import org.jspecify.annotations.NullMarked;
