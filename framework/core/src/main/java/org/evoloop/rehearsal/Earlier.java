package org.evoloop.rehearsal;

import java.util.Map;
import org.evoloop.engine.Core;
import org.evoloop.engine.Pending;
import org.evoloop.engine.Tally;
import org.evoloop.evolution.Configuration;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * A core before an input.
 *
 * @param current the occurrence in progress; null if there is none
 * @param undecided whether nothing was decided about that
 * @param resumed whether its plan was to be resumed
 * @param timers when the timers of the visit are due
 */
record Earlier(
        @Nullable Pending current,
        boolean undecided,
        boolean resumed,
        Configuration at,
        long steps,
        long visit,
        Tally tally,
        Map<Event, Long> timers) {

    static Earlier of(Core core, Chronicle chronicle) {
        return new Earlier(
                chronicle.begun(),
                chronicle.isUndecided(),
                core.resumed() != null,
                core.at(),
                core.steps(),
                core.visit(),
                core.tally(),
                Map.copyOf(chronicle.timers()));
    }

    /** The number of the occurrence in progress; 0 if there is none. */
    long number() {
        return Plans.numberOf(current);
    }

    /** When a timer of this name is due; null if there is none. */
    @Nullable
    Long due(Event timer) {
        for (Map.Entry<Event, Long> each : timers.entrySet()) {
            if (each.getKey().toString().equals(timer.toString())) {
                return each.getValue();
            }
        }
        return null;
    }
}
