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
 * The cheapest ways through the original model over events that can be sent (the paper's {@code getEvents}). A way on which
 * a guard decides is taken only if there is none without. Of ways of equal cost the one of fewer events is taken; of those
 * with equally many the one that, in the state where the two part, takes the transition that the model names first.
 *
 * <p>Threading: not thread-safe; it remembers what it has searched.
 */
final class PathPlanner {
    /** Searches that are kept: configurations of one state of the device are decided near each other. */
    private static final int KEPT = 64;

    private final StateMachine original;
    private final DeviceEvents device;
    private final GuardedTriggers guards;
    private final List<Transition> avoided;
    /** The {@link #KEPT} that were asked last. */
    private final Map<State, PathSearch> searches = new LinkedHashMap<>(KEPT, 0.75f, true) {
        @Override
        protected boolean removeEldestEntry(Map.Entry<State, PathSearch> eldest) {
            return size() > KEPT;
        }
    };

    PathPlanner(StateMachine original, DeviceEvents device) {
        this(original, device, List.of());
    }

    /** @param avoided steps that are not taken */
    PathPlanner(StateMachine original, DeviceEvents device, List<Step> avoided) {
        this.avoided = avoided.stream().map(Step::transition).toList();
        this.original = original;
        this.device = device;
        this.guards = new GuardedTriggers(original);
    }

    /**
     * The steps from {@code source} to the one of {@code goals} to which the cheapest way leads: none if it is one of them,
     * empty if there is no way.
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

    /** The step over {@code transition} if it can be sent; null if it cannot, or a guard on it cannot be asked. */
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

    /** What a step costs; a step that a guard decides costs more than any way without. */
    long costOf(Step step) {
        return device.costOf(step.trigger()) + (step.conditional() ? PathSearch.CONDITIONAL : 0);
    }

    boolean mayPass(State state) {
        return !device.doNotPass().contains(state) && !device.doNotPass().contains(original.withoutMemory(state));
    }
}
