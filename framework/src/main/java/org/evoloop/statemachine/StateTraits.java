package org.evoloop.statemachine;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * What a machine says of one of its states beside its transitions.
 *
 * @param activities see {@link StateMachine#activities}
 * @param withoutMemory see {@link StateMachine#withoutMemory}; null for the state itself
 */
record StateTraits(List<String> activities, @Nullable State withoutMemory) {
    static final StateTraits NONE = new StateTraits(List.of(), null);

    StateTraits {
        activities = List.copyOf(activities);
    }

    StateTraits withActivities(List<String> names) {
        return new StateTraits(names, withoutMemory);
    }

    StateTraits withWithoutMemory(State plain) {
        return new StateTraits(activities, plain);
    }
}
