/**
 * Shared by all measurements: the rows of the table, processes to measure in and what is measured of them, the table
 * itself and the results of a run.
 *
 * <p>This package may use no other package of the benchmarks.
 */
@NullMarked
package org.evoloop.benchmarks.report;

import org.jspecify.annotations.NullMarked;
