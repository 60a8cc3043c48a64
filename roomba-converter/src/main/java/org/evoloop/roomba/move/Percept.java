package org.evoloop.roomba.move;

import org.evoloop.roomba.camera.Look;
import org.evoloop.roomba.move.phase.Ending;
import org.evoloop.roomba.session.Telemetry;

/**
 * What Move monitors: the robot's newest frame, and the last look by then.
 *
 * @param nanos when the percept was created, on the clock that also dates the look
 * @param person why a person at the robot has ended Move, or {@link Ending#NONE}
 * @param heard whether the frame has just come; else the robot has been silent since, for the frame limit or longer
 */
record Percept(long nanos, Telemetry telemetry, Look look, Ending person, boolean heard) {}
