package org.evoloop.roomba.simulator.behavior;

import org.evoloop.roomba.simulator.body.Body;

/**
 * Straight runs with turns between, for ever; also how the robot looks for its dock. As every turn is the same, the runs
 * form a star that stays in one place.
 */
public final class Wandering implements Behavior {
    private static final double RUN_SECONDS = 4;
    private static final double TURN_SECONDS = 1.3;
    private static final double RUN_MM_PER_S = 300;
    private static final double TURN_MM_PER_S = 200;

    private long ticks;

    @Override
    public boolean steer(Body body) {
        double secondsInRound = ticks++ * Body.TICK_SECONDS % (RUN_SECONDS + TURN_SECONDS);
        if (secondsInRound < RUN_SECONDS) {
            body.drive(RUN_MM_PER_S, RUN_MM_PER_S);
        } else {
            body.drive(TURN_MM_PER_S, -TURN_MM_PER_S);
        }
        return true;
    }
}
