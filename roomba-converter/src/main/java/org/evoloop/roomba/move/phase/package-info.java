/**
 * What Move does next: from a situation, and from what it is about, to a maneuver and to what it is about then. All of
 * it is immutable, and pure functions; nothing here knows a robot, a sensor or a loop.
 *
 * <p>This package may use {@code org.evoloop.roomba.oi}, and of {@code org.evoloop.roomba.session} what a robot tells.
 */
@NullMarked
package org.evoloop.roomba.move.phase;

import org.jspecify.annotations.NullMarked;
