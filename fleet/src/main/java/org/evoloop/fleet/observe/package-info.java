/** Metrics and health of an instance or a gateway, over HTTP. It may use no other package of the fleet, nor Kafka. */
@NullMarked
package org.evoloop.fleet.observe;

import org.jspecify.annotations.NullMarked;
