/**
 * How bytes travel between the converter and a device: a serial port, or memory for tests, and the line that wakes a
 * sleeping device. What the bytes mean is no business of this package.
 *
 * <p>It may use {@code org.evoloop.natives}.
 */
@NullMarked
package org.evoloop.link;

import org.jspecify.annotations.NullMarked;
