/**
 * Events of Java Flight Recorder (JDK Flight Recorder, package {@code jdk.jfr}): what a loop and a converter do, and
 * how long it takes. While no recording is running, they cost one check of a flag.
 *
 * <p>This package uses nothing else of Evoloop, and is not exported: a recording knows the events by their names.
 */
@NullMarked
package org.evoloop.flight;

import org.jspecify.annotations.NullMarked;
