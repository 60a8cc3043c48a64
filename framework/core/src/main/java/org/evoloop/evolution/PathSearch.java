package org.evoloop.evolution;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.Set;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * Dijkstra's search from one state, done lazily: it stops at the target and continues from there when a farther one is
 * requested. Ties are broken as {@link PathPlanner} says.
 */
final class PathSearch {
    /** More than a path of a million events of the highest cost. */
    static final long CONDITIONAL = 1L << 40;

    private final PathPlanner planner;
    private final State source;
    private final Map<State, Arrival> arrivals = new HashMap<>();
    private final Set<State> settled = new HashSet<>();
    private final PriorityQueue<Arrival> frontier = new PriorityQueue<>();

    /** The end of a path. Its predecessor is settled, so no better path replaces it. */
    private record Arrival(
            State state,
            long cost,
            int events,
            @Nullable Arrival before,
            @Nullable Step step,
            int drawn) implements Comparable<Arrival> {
        @Override
        public int compareTo(Arrival other) {
            return cost != other.cost ? Long.compare(cost, other.cost) : Integer.compare(events, other.events);
        }

        boolean isBetterThan(Arrival other) {
            int order = compareTo(other);
            return order != 0 ? order < 0 : isDrawnBefore(other);
        }

        /**
         * Of two paths with equally many events: whether this one takes the transition drawn first where they diverge.
         */
        private boolean isDrawnBefore(Arrival other) {
            Arrival one = this;
            Arrival two = other;
            while (one.before != null && two.before != null && !one.before.state.equals(two.before.state)) {
                one = one.before;
                two = two.before;
            }
            return one.drawn < two.drawn;
        }
    }

    PathSearch(PathPlanner planner, State source) {
        this.planner = planner;
        this.source = source;
        arrive(new Arrival(source, 0, 0, null, null, 0));
    }

    /** The one of {@code goals} with the cheapest path; null if there is no path to any. */
    @Nullable
    State nearest(List<State> goals) {
        Arrival nearest = null;
        for (State goal : goals) {
            Arrival arrival = lastStepTo(goal) == null ? null : arrivals.get(goal);
            if (arrival != null && (nearest == null || arrival.compareTo(nearest) < 0)) {
                nearest = arrival;
            }
        }
        return nearest == null ? null : nearest.state;
    }

    /** The last step of the cheapest path to {@code target}; null for the source itself and if there is no path. */
    @Nullable
    Step lastStepTo(State target) {
        while (!settled.contains(target) && !frontier.isEmpty()) {
            State next = frontier.remove().state;
            Arrival best = arrivals.get(next);
            if (best != null && settled.add(next)) {
                expand(best);
            }
        }
        Arrival arrival = settled.contains(target) ? arrivals.get(target) : null;
        return arrival == null ? null : arrival.step;
    }

    private void expand(Arrival at) {
        if (!at.state.equals(source) && !planner.mayPass(at.state)) {
            return;
        }
        List<Transition> transitions = planner.transitionsFrom(at.state);
        for (int drawn = 0; drawn < transitions.size(); drawn++) {
            Transition transition = transitions.get(drawn);
            Step step = settled.contains(transition.target()) ? null : planner.stepOver(transition);
            if (step != null) {
                long cost = at.cost + planner.costOf(step);
                arrive(new Arrival(step.target(), cost, at.events + 1, at, step, drawn));
            }
        }
    }

    private void arrive(Arrival arrival) {
        Arrival known = arrivals.get(arrival.state);
        if (known == null || arrival.isBetterThan(known)) {
            arrivals.put(arrival.state, arrival);
            frontier.add(arrival);
        }
    }
}
