package org.evoloop.device;

import org.evoloop.function.NewFunction;
import org.evoloop.function.Visit;

/**
 * A function that a connection runs; where that is only played, it does nothing.
 *
 * <p>Threading: as {@link NewFunction}.
 */
record PlayableFunction(Connection where, NewFunction runs) implements NewFunction {
    @Override
    public void run(Visit visit) throws Exception {
        if (where.isPlayed()) {
            visit.say("the function of " + visit.state() + " runs at " + where.name());
        } else {
            runs.run(visit);
        }
    }
}
