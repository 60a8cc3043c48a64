package org.evoloop.roomba.move;

import org.evoloop.roomba.camera.Look;
import org.evoloop.roomba.session.Telemetry;

/**
 * What Move monitors: the robot's newest frame, and what was seen last by then.
 *
 * @param nanos when this was put together, on the clock that also dates the look
 */
record Percept(long nanos, Telemetry telemetry, Look look) {}
