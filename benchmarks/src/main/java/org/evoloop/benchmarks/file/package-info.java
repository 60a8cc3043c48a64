/**
 * What a device file costs, compared with the same in Java.
 *
 * <p>This package may use the framework and {@code org.evoloop.benchmarks.report}.
 */
@NullMarked
package org.evoloop.benchmarks.file;

import org.jspecify.annotations.NullMarked;
