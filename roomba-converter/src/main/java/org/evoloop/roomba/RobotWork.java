package org.evoloop.roomba;

import java.util.Set;
import java.util.function.Supplier;
import org.evoloop.function.NewFunction;
import org.evoloop.function.Visit;
import org.evoloop.statemachine.State;

/**
 * A new function in which the robot does the work itself: it is sent an event, and reports the end by itself.
 *
 * @param device supplies the state of the robot's model
 * @param words describes the work, for people
 * @param event the event that starts the work
 * @param underWay the device states in which the work has begun; in these, a second command after a restart would pause
 *     it
 */
record RobotWork(Supplier<State> device, String words, String event, Set<String> underWay) implements NewFunction {

    /** Where the robot docks or has docked. */
    static final Set<String> DOCKING =
            Set.of(RobotEvents.STATE_DOCK, RobotEvents.STATE_CHARGING, RobotEvents.STATE_CHARGED);

    @Override
    public void run(Visit visit) throws InterruptedException {
        visit.progress(words);
        if (!underWay.contains(device.get().name())) {
            visit.send(event);
        }
    }
}
