/**
 * The only package that uses OpenCV's classes. {@link org.evoloop.roomba.camera.vision.OpenCv} loads it together with
 * the installed OpenCV; no other code may refer to it. Code that creates a {@code Mat} must release it: the garbage
 * collector does not know of its native memory, and methods that return a {@code Mat} return a new one.
 *
 * <p>This package may use {@code camera} and {@code camera.vision}.
 */
@NullMarked
package org.evoloop.roomba.camera.opencv;

import org.jspecify.annotations.NullMarked;
