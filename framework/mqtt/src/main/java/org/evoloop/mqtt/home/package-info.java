/**
 * A converter in Home Assistant, by MQTT discovery: {@link org.evoloop.mqtt.home.HomeAssistant} publishes it and takes its
 * commands, {@link org.evoloop.mqtt.home.HomeEntity} is a native entity that a program or a device file makes of its states,
 * and {@link org.evoloop.mqtt.home.HomeSetting} one that changes how the converter works.
 *
 * <p>It uses the connection of {@link org.evoloop.mqtt}, which knows nothing of it.
 */
@NullMarked
package org.evoloop.mqtt.home;

import org.jspecify.annotations.NullMarked;
