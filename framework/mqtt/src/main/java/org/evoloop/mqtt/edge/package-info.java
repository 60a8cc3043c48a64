/**
 * A device at the edge of a fleet: {@link org.evoloop.mqtt.edge.EdgeDevice} has the parts of a converter speak with the fleet's
 * gateway, over an MQTT broker and whatever is killed or unplugged in between.
 */
@NullMarked
package org.evoloop.mqtt.edge;

import org.jspecify.annotations.NullMarked;
