/**
 * The fleet as a topology of Kafka Streams: a task holds the devices of one partition, and passes each its records. It
 * may use {@code device} and {@code wire}.
 */
@NullMarked
package org.evoloop.fleet.stream;

import org.jspecify.annotations.NullMarked;
