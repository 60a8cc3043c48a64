package org.evoloop.roomba;

import java.util.Set;
import java.util.function.Supplier;
import org.evoloop.function.NewFunction;
import org.evoloop.function.Visit;
import org.evoloop.statemachine.State;

/** A new function in which the robot goes to its dock and charges; the robot itself tells that it has, {@code charged}. */
final class Charge implements NewFunction {
    private static final Set<String> UNDER_WAY =
            Set.of(RobotEvents.STATE_DOCK, RobotEvents.STATE_CHARGING, RobotEvents.STATE_CHARGED);

    private final Supplier<State> device;

    /** @param device where the robot's model is */
    Charge(Supplier<State> device) {
        this.device = device;
    }

    @Override
    public void run(Visit visit) throws InterruptedException {
        visit.progress("charging first, then going on");
        if (!UNDER_WAY.contains(device.get().name())) {
            visit.send(RobotEvents.DOCK);
        }
    }
}
