package org.evoloop.roomba;

import java.util.function.Supplier;
import org.evoloop.function.NewFunction;
import org.evoloop.function.Visit;
import org.evoloop.statemachine.State;

/** A new function in which the robot cleans the spot where it stands; the robot itself tells its end, {@code endSpot}. */
final class SpotClean implements NewFunction {
    private final Supplier<State> device;

    /** @param device where the robot's model is */
    SpotClean(Supplier<State> device) {
        this.device = device;
    }

    @Override
    public void run(Visit visit) throws InterruptedException {
        visit.progress("cleaning the spot");
        // After a restart the robot may be at it still, and a second command would pause it.
        if (!device.get().name().equals(RobotEvents.STATE_SPOT)) {
            visit.send(RobotEvents.SPOT);
        }
    }
}
