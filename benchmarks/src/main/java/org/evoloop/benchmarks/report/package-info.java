/**
 * What all measurements have in common: a row of the table, processes to measure in, what is measured of
 * them, the table itself and the results of a run.
 *
 * <p>This room may use nothing of the other rooms.
 */
@NullMarked
package org.evoloop.benchmarks.report;

import org.jspecify.annotations.NullMarked;
