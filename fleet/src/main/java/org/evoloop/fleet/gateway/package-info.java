/**
 * Between an MQTT broker, where devices are, and a fleet's topics: what devices tell is kept in files until the fleet
 * has it, and commands reach a device once. It may use {@code device}, {@code wire} and {@code stream}.
 */
@NullMarked
package org.evoloop.fleet.gateway;

import org.jspecify.annotations.NullMarked;
