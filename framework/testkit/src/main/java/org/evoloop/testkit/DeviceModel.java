package org.evoloop.testkit;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.evoloop.evolution.GuardedTriggers;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * The true state of a device, by its model; its time triggers are its own.
 *
 * <p>Threading: thread-safe.
 */
final class DeviceModel {
    private final StateMachine model;
    private final GuardedTriggers guards;
    private final List<Clock.Timer> timers = new ArrayList<>();
    private final List<String> effects = new ArrayList<>();
    private Predicate<String> holds = guard -> false;
    private State state;
    private @Nullable Clock clock;

    DeviceModel(StateMachine model) {
        this.model = model;
        this.guards = new GuardedTriggers(model);
        this.state = model.initial();
    }

    /** Starts its time. */
    synchronized void start(Clock its) {
        clock = its;
        enter(state);
    }

    synchronized void holds(Predicate<String> condition) {
        holds = condition;
    }

    synchronized State state() {
        return state;
    }

    synchronized List<String> effects() {
        return List.copyOf(effects);
    }

    StateMachine machine() {
        return model;
    }

    /** Whether it has a transition for {@code event} now. */
    synchronized boolean knows(String event) {
        return transition(event) != null;
    }

    /** Takes the transition of {@code event}; returns false, without an effect, if there is none now. */
    synchronized boolean take(String event) {
        Transition taken = transition(event);
        if (taken == null) {
            return false;
        }
        effects.addAll(taken.effects());
        if (!taken.internal()) {
            enter(taken.target());
        }
        return true;
    }

    private @Nullable Transition transition(String event) {
        Event resolved = guards.resolve(state, new Event(event), holds);
        return resolved == null ? null : model.transition(state, resolved).orElse(null);
    }

    /**
     * Puts it into another state, whatever its model says.
     *
     * @throws IllegalArgumentException if it has no such state
     */
    synchronized void put(String name) {
        State next = new State(name);
        if (!model.hasState(next)) {
            throw new IllegalArgumentException("the device has no state " + name + Names.hint(name, model.states()));
        }
        enter(next);
    }

    private void enter(State next) {
        timers.forEach(Clock.Timer::cancel);
        timers.clear();
        state = next;
        Clock its = clock;
        if (its == null) {
            return;
        }
        for (Transition transition : model.transitionsFrom(next)) {
            String event = transition.event().name();
            transition.event().timeTrigger().ifPresent(delay -> timers.add(its.schedule(delay, () -> take(event))));
        }
    }
}
