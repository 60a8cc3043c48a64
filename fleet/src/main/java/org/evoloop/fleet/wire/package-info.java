/**
 * The names of a fleet's topics and the format of their records: JSON, schema version 1, as docs/fleet.md describes it.
 * It may use {@code device}, {@code org.evoloop.mqtt.edge} and {@code org.evoloop.payload}, and does not depend on Kafka.
 */
@NullMarked
package org.evoloop.fleet.wire;

import org.jspecify.annotations.NullMarked;
