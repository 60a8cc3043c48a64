package org.evoloop.evolution;

import java.util.ArrayDeque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * Finds the cheapest paths through the original model by events that can be sent (the paper's {@code getEvents}). A
 * path that depends on a guard is taken only if there is none without. Of paths of equal cost, the one with fewer
 * events is taken; of those with equally many, the one that, where the two diverge, takes the transition listed first
 * in the model.
 *
 * <p>Threading: not thread-safe; it caches its searches.
 */
final class PathPlanner {
    /** The size of the cache: configurations with the same state of the device are decided close together. */
    private static final int KEPT = 64;

    private final StateMachine original;
    private final DeviceEvents device;
    private final GuardedTriggers guards;
    private final List<Transition> avoided;
    /** The last {@link #KEPT} searches used. */
    private final Map<State, PathSearch> searches = new LinkedHashMap<>(KEPT, 0.75f, true) {
        @Override
        protected boolean removeEldestEntry(Map.Entry<State, PathSearch> eldest) {
            return size() > KEPT;
        }
    };

    PathPlanner(StateMachine original, DeviceEvents device) {
        this(original, device, List.of());
    }

    /** @param avoided steps that must not be taken */
    PathPlanner(StateMachine original, DeviceEvents device, List<Step> avoided) {
        this.avoided = avoided.stream().map(Step::transition).toList();
        this.original = original;
        this.device = device;
        this.guards = new GuardedTriggers(original);
    }

    /**
     * The steps of the cheapest path from {@code source} to any of {@code goals}: none if it is one of them, empty if
     * there is no path.
     */
    Optional<List<Step>> shortestPath(State source, List<State> goals) {
        if (goals.contains(source)) {
            return Optional.of(List.of());
        }
        PathSearch search = searches.computeIfAbsent(source, from -> new PathSearch(this, from));
        State goal = goals.size() == 1 ? goals.get(0) : search.nearest(goals);
        Step last = goal == null ? null : search.lastStepTo(goal);
        if (last == null) {
            return Optional.empty();
        }
        ArrayDeque<Step> path = new ArrayDeque<>();
        for (Step step = last; step != null; step = search.lastStepTo(step.source())) {
            path.addFirst(step);
        }
        return Optional.of(List.copyOf(path));
    }

    List<Transition> transitionsFrom(State state) {
        return original.transitionsFrom(state);
    }

    /** The step along {@code transition} if it can be sent; null if it cannot, or its guard cannot be evaluated. */
    @Nullable
    Step stepOver(Transition transition) {
        if (!device.sendable().contains(transition.event().trigger())
                || guards.shadowOf(transition) != null
                || avoided.contains(transition)) {
            return null;
        }
        var conditions = guards.conditionsOf(transition);
        return device.boundGuards().containsAll(conditions) ? new Step(transition, false, !conditions.isEmpty()) : null;
    }

    /** The cost of a step; a step that depends on a guard costs more than any path without guards. */
    long costOf(Step step) {
        return device.costOf(step.trigger()) + (step.conditional() ? PathSearch.CONDITIONAL : 0);
    }

    boolean mayPass(State state) {
        return !device.doNotPass().contains(state) && !device.doNotPass().contains(original.withoutMemory(state));
    }
}
