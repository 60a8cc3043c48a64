package org.evoloop.roomba.simulator.behavior;

import org.evoloop.roomba.simulator.body.Body;

/**
 * Straight runs with turns in between, until the robot is stuck. In a room a run ends at an obstacle; on an open plain
 * all turns are equal, and the runs form a star that stays in one place.
 */
public final class Wandering implements Behavior {
    private static final double OPEN_RUN_SECONDS = 4;

    /** Through ten metres of room. */
    private static final double LONGEST_RUN_SECONDS = 33;

    private static final double TURN_SECONDS = 1.3;
    private static final double RUN_MM_PER_S = 300;

    private final Reflex reflex = new Reflex();
    private long ticks;

    @Override
    public boolean steer(Body body) {
        if (reflex.steer(body)) {
            ticks = 0;
            return !reflex.isStuck();
        }
        double runSeconds = body.room().isOpen() ? OPEN_RUN_SECONDS : LONGEST_RUN_SECONDS;
        if (ticks++ * Body.TICK_SECONDS % (runSeconds + TURN_SECONDS) < runSeconds) {
            body.drive(RUN_MM_PER_S, RUN_MM_PER_S);
        } else {
            Pursuit.spin(body, 1);
        }
        return true;
    }
}
