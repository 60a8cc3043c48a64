package org.evoloop.roomba.simulator.behavior;

import org.evoloop.roomba.simulator.body.Body;

/** Something the robot does by itself, a tick at a time. */
public interface Behavior {
    /**
     * Sets wheels and motors for the next tick.
     *
     * @return false when the behaviour has come to its end; whoever runs it then stops the robot
     */
    boolean steer(Body body);
}
