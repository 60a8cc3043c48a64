/**
 * Time as Evoloop sees it: a clock that is injected, so that a test or a simulation decides how it passes.
 *
 * <p>This room uses nothing of Evoloop; nothing else in it may read the time of the machine or put a thread to sleep.
 */
@NullMarked
package org.evoloop.time;

import org.jspecify.annotations.NullMarked;
