/**
 * Connects the devices of an MQTT broker to a fleet's topics: records from devices are stored in files until the fleet
 * has them, and each command reaches its device once. It may use {@code device}, {@code wire} and {@code stream}.
 */
@NullMarked
package org.evoloop.fleet.gateway;

import org.jspecify.annotations.NullMarked;
