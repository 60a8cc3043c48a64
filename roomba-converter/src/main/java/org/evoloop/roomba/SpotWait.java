package org.evoloop.roomba;

import java.time.Duration;
import org.evoloop.function.NewFunction;
import org.evoloop.function.Visit;

/**
 * The new function of state SpotWait: gives the user time for a second press, then raises {@code timeout}. If the model
 * has a time trigger instead, the trigger sets the time, and no function runs.
 */
final class SpotWait implements NewFunction {
    private final Duration patience;

    SpotWait(Duration patience) {
        this.patience = patience;
    }

    @Override
    public void run(Visit visit) {
        if (visit.accepts(RobotEvents.TIMEOUT)) {
            visit.finishAfter(patience, RobotEvents.TIMEOUT);
        }
    }
}
