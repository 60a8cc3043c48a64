/**
 * The pins of a Raspberry Pi: {@link org.evoloop.gpio.GpioMonitor} turns switches into events, {@link
 * org.evoloop.gpio.GpioExecute} operates what is connected to a pin, and both use {@link org.evoloop.gpio.Pins}.
 *
 * <p>It uses the core and Pi4J.
 */
@NullMarked
package org.evoloop.gpio;

import org.jspecify.annotations.NullMarked;
