/**
 * Entities of Home Assistant as a converter's device or controller, over its WebSocket API: {@link
 * org.evoloop.homeassistant.HomeConnection} maintains the connection, and {@link org.evoloop.homeassistant.HomeMonitor} and
 * {@link org.evoloop.homeassistant.HomeExecute} connect a {@link org.evoloop.homeassistant.HomeDevice} through it.
 *
 * <p>The API is described at <a href="https://developers.home-assistant.io/docs/api/websocket">developers.home-assistant.io</a>.
 *
 * <p>It uses the packages {@code payload} and {@code payload.report}, and the core.
 */
@NullMarked
package org.evoloop.homeassistant;

import org.jspecify.annotations.NullMarked;
