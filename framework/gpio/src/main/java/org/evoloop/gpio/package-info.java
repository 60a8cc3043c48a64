/**
 * Pins of a Raspberry Pi: {@link org.evoloop.gpio.GpioMonitor} makes events of switches, {@link
 * org.evoloop.gpio.GpioExecute} operates what hangs on a pin, and {@link org.evoloop.gpio.Pins} has both.
 *
 * <p>It uses the core and Pi4J.
 */
@NullMarked
package org.evoloop.gpio;

import org.jspecify.annotations.NullMarked;
