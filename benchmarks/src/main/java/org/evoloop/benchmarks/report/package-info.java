/**
 * What all measurements have in common: a row of the table, processes to measure in, and the table itself.
 *
 * <p>This room may use nothing of the other rooms.
 */
@NullMarked
package org.evoloop.benchmarks.report;

import org.jspecify.annotations.NullMarked;
