package org.evoloop.roomba.simulator.behavior;

import org.evoloop.roomba.simulator.body.Body;

/** An activity of the robot itself, one tick at a time. */
public interface Behavior {
    /**
     * Sets wheels and motors for the next tick.
     *
     * @return false when the behaviour has ended; the caller then stops the robot
     */
    boolean steer(Body body);
}
