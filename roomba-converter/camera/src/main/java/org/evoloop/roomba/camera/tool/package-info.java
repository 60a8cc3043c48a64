/**
 * The camera commands: test it, calibrate it, and print the marker that it looks for.
 *
 * <p>This package may use all of {@code camera} and {@code org.evoloop.time}.
 */
@NullMarked
package org.evoloop.roomba.camera.tool;

import org.jspecify.annotations.NullMarked;
