/**
 * How soon the studio answers while one types.
 *
 * <p>This package uses {@code report}.
 */
@NullMarked
package org.evoloop.benchmarks.studio;

import org.jspecify.annotations.NullMarked;
