/** A Kafka broker in this process, for demo, benchmark and tests. It may use no other package of the fleet. */
@NullMarked
package org.evoloop.fleet.broker;

import org.jspecify.annotations.NullMarked;
