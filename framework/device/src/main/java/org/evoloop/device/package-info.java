/**
 * A device file: {@link org.evoloop.device.DeviceFile} reads it and checks it against its models, {@link
 * org.evoloop.device.Connection}s are its ways to the device and the controller, and {@link
 * org.evoloop.device.Scenario}s try it without the device.
 *
 * <p>A file is wiring: everything that happens is done by components that a Java program could use as well.
 */
@NullMarked
package org.evoloop.device;

import org.jspecify.annotations.NullMarked;
