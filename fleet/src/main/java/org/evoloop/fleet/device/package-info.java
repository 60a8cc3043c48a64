/**
 * The converter of one device in a fleet, without threads, clocks, files or Kafka: the same core as everywhere, told
 * one thing after the other, and kept as text in between. It may use nothing else of the fleet.
 */
@NullMarked
package org.evoloop.fleet.device;

import org.jspecify.annotations.NullMarked;
