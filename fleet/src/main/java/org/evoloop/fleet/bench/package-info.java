/** The fleet's benchmark, {@code evoloop bench --fleet}. It may use all of the fleet. */
@NullMarked
package org.evoloop.fleet.bench;

import org.jspecify.annotations.NullMarked;
