/**
 * A converter at an MQTT broker: {@link org.evoloop.mqtt.BrokerConnection} keeps the connection, {@link
 * org.evoloop.mqtt.MqttMonitor} and {@link org.evoloop.mqtt.MqttExecute} have a controller or a device behind it, and
 * {@link org.evoloop.mqtt.HomeAssistant} shows a converter in Home Assistant and has it operated there.
 *
 * <p>It uses the console and what that uses. HiveMQ's client is loaded when a connection is opened, and not before.
 */
@NullMarked
package org.evoloop.mqtt;

import org.jspecify.annotations.NullMarked;
