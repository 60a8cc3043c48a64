/**
 * A serial port for a controller or a device that speaks in lines of text.
 *
 * <p>It uses the line protocol and {@code org.evoloop.link}, which knows what is wrong with a port.
 */
@NullMarked
package org.evoloop.serial;

import org.jspecify.annotations.NullMarked;
