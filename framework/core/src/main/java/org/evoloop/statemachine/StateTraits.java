package org.evoloop.statemachine;

import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * The properties of a state other than its transitions.
 *
 * @param activities see {@link StateMachine#activities}
 * @param deferred see {@link StateMachine#deferred}
 * @param withoutMemory see {@link StateMachine#withoutMemory}; null for the state itself
 * @param paths see {@link StateMachine#paths}; empty for the state's name
 * @param end see {@link StateMachine#isEnd}
 */
record StateTraits(
        List<String> activities,
        Set<Event> deferred,
        @Nullable State withoutMemory,
        List<String> paths,
        boolean end) {
    static final StateTraits NONE = new StateTraits(List.of(), Set.of(), null, List.of(), false);

    StateTraits {
        activities = List.copyOf(activities);
        deferred = Collections.unmodifiableSet(new LinkedHashSet<>(deferred));
        paths = List.copyOf(paths);
    }

    StateTraits withActivities(List<String> names) {
        return new StateTraits(names, deferred, withoutMemory, paths, end);
    }

    StateTraits withDeferred(Event event) {
        Set<Event> all = new LinkedHashSet<>(deferred);
        all.add(event);
        return new StateTraits(activities, all, withoutMemory, paths, end);
    }
}
