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
 * @param device see {@link StateMachine#deviceState}; null for none
 * @param inherited see {@link StateMachine#inheritsDeviceState}
 * @param sends see {@link StateMachine#sends}
 */
record StateTraits(
        List<String> activities,
        Set<Event> deferred,
        @Nullable State withoutMemory,
        List<String> paths,
        boolean end,
        @Nullable String device,
        boolean inherited,
        Set<Event> sends) {
    static final StateTraits NONE = new StateTraits(List.of(), Set.of(), null, List.of(), false, null, false, Set.of());

    StateTraits {
        activities = List.copyOf(activities);
        deferred = Collections.unmodifiableSet(new LinkedHashSet<>(deferred));
        paths = List.copyOf(paths);
        sends = Collections.unmodifiableSet(new LinkedHashSet<>(sends));
    }

    StateTraits withActivities(List<String> names) {
        return new StateTraits(names, deferred, withoutMemory, paths, end, device, inherited, sends);
    }

    StateTraits withDeferred(Event event) {
        return new StateTraits(activities, with(deferred, event), withoutMemory, paths, end, device, inherited, sends);
    }

    StateTraits withDevice(String state) {
        return new StateTraits(activities, deferred, withoutMemory, paths, end, state, inherited, sends);
    }

    StateTraits withInherited() {
        return new StateTraits(activities, deferred, withoutMemory, paths, end, device, true, sends);
    }

    StateTraits withSends(Event event) {
        return new StateTraits(activities, deferred, withoutMemory, paths, end, device, inherited, with(sends, event));
    }

    private static Set<Event> with(Set<Event> some, Event event) {
        Set<Event> all = new LinkedHashSet<>(some);
        all.add(event);
        return all;
    }
}
