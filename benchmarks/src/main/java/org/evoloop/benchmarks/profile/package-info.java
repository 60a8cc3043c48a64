/**
 * Where a program's time and memory go: work that is recorded with the JDK's Flight Recorder, and the recording told as
 * text.
 *
 * <p>This room may use nothing of the other rooms.
 */
@NullMarked
package org.evoloop.benchmarks.profile;

import org.jspecify.annotations.NullMarked;
