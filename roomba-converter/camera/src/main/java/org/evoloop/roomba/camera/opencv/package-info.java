/**
 * The one place that touches OpenCV's classes. It is loaded by {@link org.evoloop.roomba.camera.vision.OpenCv} together
 * with the machine's OpenCV, and nothing else may name it. Every {@code Mat} is released by who made it: the garbage
 * collector knows nothing of the native memory behind one, and methods that return a {@code Mat} return a new one.
 *
 * <p>This package may use {@code camera} and {@code camera.vision}.
 */
@NullMarked
package org.evoloop.roomba.camera.opencv;

import org.jspecify.annotations.NullMarked;
