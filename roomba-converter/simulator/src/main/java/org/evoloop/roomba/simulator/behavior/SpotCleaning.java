package org.evoloop.roomba.simulator.behavior;

import org.evoloop.roomba.simulator.body.Body;
import org.evoloop.roomba.simulator.body.CleaningMotors;
import org.evoloop.roomba.simulator.room.Pose;

/**
 * A spiral of about a metre out and in again, which ends where it began; around what is in the way the robot catches up
 * with it.
 */
public final class SpotCleaning implements Behavior {
    /** What the robot has left at the end to come to rest on the very spot. */
    private static final double HOMING_SECONDS = 2;

    private final double durationSeconds;
    private final Spiral spiral;
    private final Reflex reflex = new Reflex();
    private long ticks;

    /** From this pose on, for this long. */
    public SpotCleaning(Pose start, int durationMillis) {
        this.durationSeconds = durationMillis / 1000.0;
        this.spiral = new Spiral(start, (durationSeconds - HOMING_SECONDS) / 2);
    }

    @Override
    public boolean steer(Body body) {
        double elapsedSeconds = ticks++ * Body.TICK_SECONDS;
        body.setCleaningMotors(CleaningMotors.ON);
        if (!reflex.steer(body)) {
            if (elapsedSeconds < spiral.outwardSeconds()) {
                spiral.steerOutward(body, elapsedSeconds);
            } else {
                spiral.steerInward(body, elapsedSeconds - spiral.outwardSeconds());
            }
        }
        return ticks * Body.TICK_SECONDS < durationSeconds && !reflex.isStuck();
    }
}
