package org.evoloop.roomba;

import java.time.Duration;
import org.evoloop.function.NewFunction;
import org.evoloop.function.Visit;

/** The new function of state SpotWait: gives its user some time for a second press, then raises {@code timeout}. */
final class SpotWait implements NewFunction {
    private final Duration patience;

    SpotWait(Duration patience) {
        this.patience = patience;
    }

    @Override
    public void run(Visit visit) {
        visit.finishAfter(patience, RobotEvents.TIMEOUT);
    }
}
