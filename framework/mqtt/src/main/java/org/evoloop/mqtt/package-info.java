/**
 * A converter at an MQTT broker: {@link org.evoloop.mqtt.BrokerConnection} maintains the connection, {@link
 * org.evoloop.mqtt.MqttMonitor} and {@link org.evoloop.mqtt.MqttExecute} connect a controller or a device through it,
 * and {@link org.evoloop.mqtt.home.HomeAssistant} shows and operates a converter in Home Assistant.
 *
 * <p>It uses the console and what that uses. HiveMQ's client is loaded only when a connection is opened.
 */
@NullMarked
package org.evoloop.mqtt;

import org.jspecify.annotations.NullMarked;
