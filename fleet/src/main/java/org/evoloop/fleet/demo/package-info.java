/** Simulated devices at a fleet's topics, and the demo that shows what happens to them. It may use all of the fleet. */
@NullMarked
package org.evoloop.fleet.demo;

import org.jspecify.annotations.NullMarked;
