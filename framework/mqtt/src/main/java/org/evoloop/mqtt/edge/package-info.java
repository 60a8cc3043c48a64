/**
 * A device at the edge of a fleet: {@link org.evoloop.mqtt.edge.EdgeDevice} connects the parts of a converter with the
 * fleet's gateway over an MQTT broker, reliably, even if programs are killed or cables unplugged. A gateway and other
 * programs of a fleet use {@link org.evoloop.mqtt.edge.EdgeRecords}, too.
 */
@NullMarked
package org.evoloop.mqtt.edge;

import org.jspecify.annotations.NullMarked;
