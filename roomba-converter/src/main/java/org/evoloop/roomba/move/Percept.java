package org.evoloop.roomba.move;

import org.evoloop.roomba.camera.Look;
import org.evoloop.roomba.move.phase.Ending;
import org.evoloop.roomba.session.Telemetry;

/**
 * What Move monitors: the robot's newest frame, and what was seen last by then.
 *
 * @param nanos when this was put together, on the clock that also dates the look
 * @param person what somebody at the robot has done since Move began, if that ends it
 */
record Percept(long nanos, Telemetry telemetry, Look look, Ending person) {}
