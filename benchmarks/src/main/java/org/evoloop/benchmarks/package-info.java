/**
 * How fast the converter is, and what it allocates: JMH benchmarks and the program that runs them.
 *
 * <p>This room may use all others; none may use it. Alone beside {@code org.evoloop.time} it reads the machine's clock.
 */
@NullMarked
package org.evoloop.benchmarks;

import org.jspecify.annotations.NullMarked;
