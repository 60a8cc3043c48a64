package org.evoloop.mqtt;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * Takes the evolved system to a state by events of a controller, one after another, and waits for timers in between,
 * for example in a state that waits for a second press. When anything else happens on the way, the errand is over.
 *
 * <p>Threading: not thread-safe.
 */
final class Errand {
    static final Duration LIMIT = Duration.ofMinutes(1);

    private final StateMachine evolved;
    private final Set<String> raisable;
    private final State goal;
    private final Predicate<State> mayPass;
    private final Consumer<String> press;
    private final long deadlineNanos;
    private boolean pressed;

    /** Where the last step was taken; null before the first. */
    private @Nullable State last;

    /** Where that step leads. */
    private Set<State> expected = Set.of();

    /**
     * An errand to {@code goal}.
     *
     * @param evolved the new model
     * @param raisable the events that may be pressed
     * @param mayPass the states through which the way may lead
     * @param press presses one
     * @param nowNanos the time, by the converter's clock
     */
    Errand(
            StateMachine evolved,
            Set<String> raisable,
            State goal,
            Predicate<State> mayPass,
            Consumer<String> press,
            long nowNanos) {
        this.evolved = evolved;
        this.raisable = raisable;
        this.goal = goal;
        this.mayPass = mayPass;
        this.press = press;
        this.deadlineNanos = nowNanos + LIMIT.toNanos();
    }

    /**
     * Takes the next step when it is due.
     *
     * @param now the evolved system's state
     * @return whether there are more steps
     * @throws IllegalStateException if no path leads to the goal
     */
    boolean step(State now, long nowNanos) {
        if (evolved.alike(goal).contains(now) || nowNanos - deadlineNanos > 0) {
            return false;
        }
        if (now.equals(last)) {
            return true;
        }
        if (last != null && !expected.contains(now)) {
            return false;
        }
        Event next = firstStep(now);
        if (next == null || !(mayRaise(next) || isTimer(next))) {
            if (pressed) {
                // The functions and the device must do the rest.
                return false;
            }
            throw new IllegalStateException("nothing that a controller may raise leads from " + now + " to " + goal);
        }
        last = now;
        expected = evolved.transitionsFrom(now).stream()
                .filter(transition -> transition.event().trigger().equals(next.trigger()))
                .map(Transition::target)
                .collect(Collectors.toSet());
        if (mayRaise(next)) {
            pressed = true;
            press.accept(next.trigger().name());
        }
        return true;
    }

    private boolean mayRaise(Event event) {
        return raisable.contains(event.name());
    }

    private static boolean isTimer(Event event) {
        return event.timeTrigger().isPresent() || event.name().equals("timeout");
    }

    /** The first event of a cheapest path. */
    private @Nullable Event firstStep(State from) {
        Map<State, Integer> costs = new HashMap<>(Map.of(from, 0));
        Map<State, Event> first = new HashMap<>();
        Deque<State> changed = new ArrayDeque<>(List.of(from));
        while (!changed.isEmpty()) {
            State state = changed.remove();
            if (!state.equals(from) && !mayPass.test(state)) {
                continue;
            }
            for (Transition transition : evolved.transitionsFrom(state)) {
                State target = transition.target();
                int cost = costs.getOrDefault(state, 0) + cost(transition.event());
                if (cost < costs.getOrDefault(target, Integer.MAX_VALUE)) {
                    costs.put(target, cost);
                    first.put(target, state.equals(from) ? transition.event() : first.get(state));
                    changed.add(target);
                }
            }
        }
        return evolved.alike(goal).stream()
                .filter(first::containsKey)
                .min(Comparator.comparing(costs::get))
                .map(first::get)
                .orElse(null);
    }

    /**
     * Waiting for a timer is cheaper than a detour through other work; events of the device and of functions may never
     * come.
     */
    private int cost(Event event) {
        return mayRaise(event) ? 2 : isTimer(event) ? 1 : 20;
    }
}
