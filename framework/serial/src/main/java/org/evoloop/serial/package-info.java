/**
 * A serial port for a controller or a device that exchanges lines of text.
 *
 * <p>It uses the line protocol and {@code org.evoloop.link}, which diagnoses faults of a port.
 */
@NullMarked
package org.evoloop.serial;

import org.jspecify.annotations.NullMarked;
