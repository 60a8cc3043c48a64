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
 * Dijkstra's search from one state, as far as it has been asked for: it stops at the target and goes on from there when a
 * farther one is wanted.
 */
final class PathSearch {
    /** More than a way of a million of the dearest events. */
    static final long CONDITIONAL = 1L << 40;

    private final PathPlanner planner;
    private final State source;
    private final Map<State, Arrival> arrivals = new HashMap<>();
    private final Set<State> settled = new HashSet<>();
    private final PriorityQueue<Arrival> frontier = new PriorityQueue<>();
    private int found;

    private static final class Arrival implements Comparable<Arrival> {
        final State state;
        final long cost;
        /** Counts what was found; of arrivals of equal cost the first one counts. */
        final int order;

        final @Nullable Step lastStep;

        Arrival(State state, long cost, int order, @Nullable Step lastStep) {
            this.state = state;
            this.cost = cost;
            this.order = order;
            this.lastStep = lastStep;
        }

        @Override
        public int compareTo(Arrival other) {
            return cost != other.cost ? Long.compare(cost, other.cost) : Integer.compare(order, other.order);
        }
    }

    PathSearch(PathPlanner planner, State source) {
        this.planner = planner;
        this.source = source;
        arrive(source, 0, null);
    }

    /** The one of {@code goals} to which the cheapest way leads; null if there is no way to any. */
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

    /** The last step of the cheapest way to {@code target}; null for the source itself and if there is no way. */
    @Nullable
    Step lastStepTo(State target) {
        while (!settled.contains(target) && !frontier.isEmpty()) {
            Arrival at = frontier.remove();
            if (settled.add(at.state)) {
                expand(at);
            }
        }
        Arrival arrival = settled.contains(target) ? arrivals.get(target) : null;
        return arrival == null ? null : arrival.lastStep;
    }

    private void expand(Arrival at) {
        if (!at.state.equals(source) && !planner.mayPass(at.state)) {
            return;
        }
        for (Transition transition : planner.transitionsFrom(at.state)) {
            Step step = settled.contains(transition.target()) ? null : planner.stepOver(transition);
            if (step != null) {
                arrive(step.target(), at.cost + planner.costOf(step), step);
            }
        }
    }

    private void arrive(State state, long cost, @Nullable Step lastStep) {
        Arrival known = arrivals.get(state);
        if (known == null || cost < known.cost) {
            Arrival arrival = new Arrival(state, cost, found++, lastStep);
            arrivals.put(state, arrival);
            frontier.add(arrival);
        }
    }
}
