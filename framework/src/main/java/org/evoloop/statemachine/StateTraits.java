package org.evoloop.statemachine;

import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * What a machine says of one of its states beside its transitions.
 *
 * @param activities see {@link StateMachine#activities}
 * @param deferred see {@link StateMachine#deferred}
 * @param withoutMemory see {@link StateMachine#withoutMemory}; null for the state itself
 */
record StateTraits(
        List<String> activities,
        Set<Event> deferred,
        @Nullable State withoutMemory) {
    static final StateTraits NONE = new StateTraits(List.of(), Set.of(), null);

    StateTraits {
        activities = List.copyOf(activities);
        deferred = Collections.unmodifiableSet(new LinkedHashSet<>(deferred));
    }

    StateTraits withActivities(List<String> names) {
        return new StateTraits(names, deferred, withoutMemory);
    }

    StateTraits withDeferred(Event event) {
        Set<Event> all = new LinkedHashSet<>(deferred);
        all.add(event);
        return new StateTraits(activities, all, withoutMemory);
    }

    StateTraits withWithoutMemory(State plain) {
        return new StateTraits(activities, deferred, plain);
    }
}
