package org.evoloop.mqtt.home;

import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
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

    private final Way way;
    private final List<State> goals;
    private final Consumer<String> press;
    private final long deadlineNanos;
    private boolean pressed;

    /** Where the last step was taken; null before the first. */
    private @Nullable State last;

    /** Where that step leads. */
    private Set<State> expected = Set.of();

    /**
     * An errand to one of {@code goals}.
     *
     * @param press presses an event
     * @param nowNanos the time, by the converter's clock
     */
    Errand(Way way, Collection<State> goals, Consumer<String> press, long nowNanos) {
        this.way = way;
        this.goals = List.copyOf(goals);
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
        if (goals.contains(now) || nowNanos - deadlineNanos > 0) {
            return false;
        }
        if (now.equals(last)) {
            return true;
        }
        if (last != null && !expected.contains(now)) {
            return false;
        }
        List<Transition> rest = way.from(now, goals);
        Event next = rest.isEmpty() ? null : rest.get(0).event();
        if (next == null || !(way.mayRaise(next) || Way.isSoon(next))) {
            if (pressed) {
                // The functions and the device must do the rest.
                return false;
            }
            throw new IllegalStateException("nothing that a controller may raise leads from " + now + " to "
                    + (goals.isEmpty() ? "such a state" : goals.get(0)));
        }
        last = now;
        expected = Set.copyOf(way.targets(now, next));
        if (way.mayRaise(next)) {
            pressed = true;
            press.accept(next.trigger().name());
        }
        return true;
    }
}
