/**
 * The plan of a swap of models while a converter runs: the fate of each reachable pair of states, known before anything
 * changes.
 *
 * <p>This package may use {@code org.evoloop.evolution} and {@code org.evoloop.statemachine} only. It knows no threads,
 * clocks or files.
 *
 * @since 0.1
 */
@NullMarked
package org.evoloop.migration;

import org.jspecify.annotations.NullMarked;
