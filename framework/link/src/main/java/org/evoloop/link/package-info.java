/**
 * Moves bytes between the converter and a device, over a serial port or in memory for tests, and drives the line that
 * wakes a sleeping device. It does not interpret the bytes.
 *
 * <p>This package may use {@code org.evoloop.natives}.
 */
@NullMarked
package org.evoloop.link;

import org.jspecify.annotations.NullMarked;
