/**
 * How fast the converter is, and how much it allocates: JMH benchmarks and the program that runs them.
 *
 * <p>This package may use all others; none may use it. Apart from {@code org.evoloop.time}, only the benchmarks read
 * the machine's clock.
 */
@NullMarked
package org.evoloop.benchmarks;

import org.jspecify.annotations.NullMarked;
