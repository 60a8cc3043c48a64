/**
 * Where a program's time and memory go: records work with the JDK's Flight Recorder, and shows the recording as text.
 *
 * <p>This package may use no other package of the benchmarks.
 */
@NullMarked
package org.evoloop.benchmarks.profile;

import org.jspecify.annotations.NullMarked;
