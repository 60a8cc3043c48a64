/**
 * Time in Evoloop: an injected clock, so that a test or a simulation controls how time passes.
 *
 * <p>This package uses nothing else of Evoloop; no other package may read the machine's time or put a thread to sleep.
 */
@NullMarked
package org.evoloop.time;

import org.jspecify.annotations.NullMarked;
