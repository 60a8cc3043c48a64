package org.evoloop.models.scaffold;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.evoloop.evolution.Configuration;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * What a test does to have a transition of the new model taken.
 *
 * @param happenings from the start; the last one is to trigger the transition
 * @param after where both models stand then
 */
record Scenario(Transition transition, List<Happening> happenings, Configuration after) {
    Scenario {
        happenings = List.copyOf(happenings);
    }

    /**
     * One event.
     *
     * @param guards that hold when it comes, and no others
     * @param byDevice whether the device does it of its own accord
     * @param delay how long to wait for it; null if it comes without waiting
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
