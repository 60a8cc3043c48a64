/**
 * The converter of one device in a fleet, without threads, clocks, files or Kafka: it passes one input after the other
 * to the core that every converter uses, and is stored as text in between. It may use no other package of the fleet.
 */
@NullMarked
package org.evoloop.fleet.device;

import org.jspecify.annotations.NullMarked;
