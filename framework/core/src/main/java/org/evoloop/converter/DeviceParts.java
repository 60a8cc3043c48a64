package org.evoloop.converter;

/**
 * The components that connect a converter with its device, for {@link SystemEventConverter#addDevice}.
 *
 * @param monitor reports what the device does by itself
 * @param execute sends events to the device
 * @since 0.1
 */
public record DeviceParts(EventMonitor monitor, EventExecute execute) {}
