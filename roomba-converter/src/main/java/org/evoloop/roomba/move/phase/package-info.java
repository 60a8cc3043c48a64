/**
 * Decides Move's next action: a pure function from situation and phase to maneuver and next phase. All types are
 * immutable; nothing here depends on a robot, a sensor or a loop.
 *
 * <p>This package may use {@code org.evoloop.roomba.oi}, and of {@code org.evoloop.roomba.session} what the robot
 * reports.
 */
@NullMarked
package org.evoloop.roomba.move.phase;

import org.jspecify.annotations.NullMarked;
