package org.evoloop.models.scaffold;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.evoloop.evolution.Configuration;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * The events with which a test takes a transition of the new model.
 *
 * @param happenings from the start; the last one triggers the transition
 * @param after the states of both models afterwards
 */
record Scenario(Transition transition, List<Happening> happenings, Configuration after) {
    Scenario {
        happenings = List.copyOf(happenings);
    }

    /**
     * One event.
     *
     * @param guards the guards that hold when it occurs; all others do not
     * @param byDevice whether the device raises it
     * @param delay how long to wait for it; null for no wait
     */
    record Happening(
            String event,
            Set<String> guards,
            boolean byDevice,
            @Nullable Duration delay) {
        Happening {
            guards = Set.copyOf(guards);
        }
    }
}
