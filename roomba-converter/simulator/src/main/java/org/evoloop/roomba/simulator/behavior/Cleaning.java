package org.evoloop.roomba.simulator.behavior;

import org.evoloop.roomba.simulator.body.Body;
import org.evoloop.roomba.simulator.body.CleaningMotors;
import org.evoloop.roomba.simulator.room.Pose;

/** An outward spiral up to the first obstacle, then straight runs back and forth until it is paused. */
public final class Cleaning implements Behavior {
    private static final double SPIRAL_SECONDS = 20;

    private final Spiral spiral;
    private final Wandering wandering = new Wandering();
    private boolean spiraling = true;
    private long ticks;

    /** Starts at this pose. */
    public Cleaning(Pose start) {
        this.spiral = new Spiral(start, SPIRAL_SECONDS);
    }

    @Override
    public boolean steer(Body body) {
        double elapsedSeconds = ticks++ * Body.TICK_SECONDS;
        body.setCleaningMotors(CleaningMotors.ON);
        spiraling &= elapsedSeconds < SPIRAL_SECONDS && !Reflex.isNeeded(body);
        if (spiraling) {
            spiral.steerOutward(body, elapsedSeconds);
            return true;
        }
        return wandering.steer(body);
    }
}
