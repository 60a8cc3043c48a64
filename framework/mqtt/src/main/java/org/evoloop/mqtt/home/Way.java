package org.evoloop.mqtt.home;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * Finds ways through the new model that a controller can take.
 *
 * @param evolved the new model
 * @param raisable the events that may be pressed
 * @param mayPass the states through which a way may lead; not asked about its ends
 * @param strict whether a way has only presses and timers, and each press, whatever guards hold, leads to a state that may
 *     be passed or is a goal
 */
record Way(StateMachine evolved, Set<String> raisable, Predicate<State> mayPass, boolean strict) {
    private static final Duration LONGEST_WAIT = Duration.ofSeconds(10);

    /**
     * The transitions of a cheapest way; empty if none leads to a goal.
     *
     * @param goals with all that are alike; the first of equally cheap ones counts
     */
    List<Transition> from(State start, Collection<State> goals) {
        Map<State, Integer> costs = new HashMap<>(Map.of(start, 0));
        Map<State, Transition> last = new HashMap<>();
        Deque<State> changed = new ArrayDeque<>(List.of(start));
        while (!changed.isEmpty()) {
            State state = changed.remove();
            if (!state.equals(start) && !mayPass.test(state)) {
                continue;
            }
            for (Transition transition : evolved.transitionsFrom(state)) {
                State target = transition.target();
                int cost = costs.getOrDefault(state, 0) + cost(transition.event());
                if (cost < costs.getOrDefault(target, Integer.MAX_VALUE) && isAllowed(transition, start, goals)) {
                    costs.put(target, cost);
                    last.put(target, transition);
                    changed.add(target);
                }
            }
        }
        State nearest = null;
        for (State goal : goals) {
            if (last.containsKey(goal) && (nearest == null || cost(costs, goal) < cost(costs, nearest))) {
                nearest = goal;
            }
        }
        return nearest == null ? List.of() : back(start, nearest, last);
    }

    private static int cost(Map<State, Integer> costs, State state) {
        return costs.getOrDefault(state, Integer.MAX_VALUE);
    }

    private static List<Transition> back(State start, State goal, Map<State, Transition> last) {
        List<Transition> way = new ArrayList<>();
        for (@Nullable Transition each = last.get(goal); each != null; each = last.get(each.source())) {
            way.add(0, each);
            if (each.source().equals(start)) {
                break;
            }
        }
        return way;
    }

    private boolean isAllowed(Transition transition, State start, Collection<State> goals) {
        if (!strict) {
            return true;
        }
        Event event = transition.event();
        return isSoon(event)
                || (mayRaise(event)
                        && targets(transition.source(), event).stream()
                                .allMatch(target -> goals.contains(target)
                                        || mayPass.test(target)
                                        || target.equals(start)
                                        || target.equals(transition.source())));
    }

    /** Where the event may lead, whatever guards hold. */
    List<State> targets(State source, Event event) {
        return evolved.transitionsFrom(source).stream()
                .filter(each -> each.event().trigger().equals(event.trigger()))
                .map(Transition::target)
                .toList();
    }

    boolean mayRaise(Event event) {
        return raisable.contains(event.trigger().name());
    }

    static boolean isTimer(Event event) {
        return event.timeTrigger().isPresent() || event.name().equals("timeout");
    }

    /** Whether it is a timer that is worth waiting for. */
    static boolean isSoon(Event event) {
        return isTimer(event)
                && event.timeTrigger()
                        .filter(time -> time.compareTo(LONGEST_WAIT) > 0)
                        .isEmpty();
    }

    /**
     * Waiting for a timer is cheaper than a detour through other work; events of the device and of functions may never
     * come.
     */
    private int cost(Event event) {
        return mayRaise(event) ? 2 : isSoon(event) ? 1 : 20;
    }
}
