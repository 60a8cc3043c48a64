package org.evoloop.migration;

import java.util.List;
import java.util.Map;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Timers;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * Translates the running models' state into the next models' when these take over. A state is found by the mapping,
 * else by its name, else by its place in the drawing.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class Succession {
    private final DecisionTable running;
    private final DecisionTable next;
    private final Mapping mapping;
    private final StateMachine oldDevice;
    private final StateMachine oldSystem;
    private final CarryOver belongings;

    /**
     * @param runningTimers the timers of the running new model
     * @param nextTimers the timers of the next new model
     */
    public Succession(
            DecisionTable running, Timers runningTimers, DecisionTable next, Timers nextTimers, Mapping mapping) {
        this.running = running;
        this.next = next;
        this.mapping = mapping;
        this.oldDevice = running.models().original();
        this.oldSystem = running.models().evolved();
        this.belongings = new CarryOver(running, runningTimers, next, nextTimers, mapping);
    }

    /**
     * The fate of {@code at} now; {@link Fate.Stuck} if no swap is possible in it, even if one may be possible later.
     */
    public Fate fate(Configuration at) {
        State device = deviceState(at.original());
        if (device == null) {
            return unknown("original", "device", at.original());
        }
        State system = same(at.evolved(), oldSystem, next.models().evolved(), mapping.states(), device);
        if (system == null) {
            return unknown("new", "state", at.evolved());
        }
        Configuration there = new Configuration(device, system);
        if (!running.standsTogether(at)) {
            return new Fate.Maps(there, end(at, there), List.of(), belongings.carried(at.evolved(), system, true));
        }
        Decision settled = next.settle(there);
        if (settled instanceof Decision.Impossible impossible) {
            return new Fate.Stuck(impossible.reason());
        }
        List<Step> steps = settled.steps();
        return new Fate.Maps(there, settled.after(), steps, belongings.carried(at.evolved(), system, steps.isEmpty()));
    }

    /**
     * Where a pair of states ends to which no expected event leads. If someone has operated the device, and the next
     * models do not know the two states together, the new model follows. If a plan has failed, or facts wait that the
     * new model has yet to follow, they remain as they are, unless the state needs the device elsewhere.
     */
    private Configuration end(Configuration at, Configuration there) {
        return running.isFollowed(at) || !next.isWhereNeeded(there)
                ? next.find(there, there.original()).after()
                : there;
    }

    /** The successor of {@code state} of the running original model; null if it has none. */
    public @Nullable State deviceState(State state) {
        return same(state, oldDevice, next.models().original(), mapping.device(), null);
    }

    /** The successor of {@code step} of the running original model; null if it has none. */
    public @Nullable Step step(Step step) {
        State source = deviceState(step.source());
        Transition transition = source == null
                ? null
                : next.models().original().transition(source, step.event()).orElse(null);
        return transition == null ? null : new Step(transition, step.trigger(), step.byDevice(), step.conditional());
    }

    /**
     * The transition of the next new model that leads into {@code state} as {@code by} led into its predecessor; for a
     * new state without such a transition, the one drawn first. It determines which function runs there.
     */
    public @Nullable Transition entry(State state, @Nullable Transition by) {
        StateMachine now = next.models().evolved();
        State source = by == null ? null : same(by.source(), oldSystem, now, mapping.states(), null);
        Transition like = by == null || source == null
                ? null
                : now.transition(source, by.event()).orElse(null);
        if (like != null && like.target().equals(state)) {
            return like;
        }
        return !next.isNew(state)
                ? null
                : now.transitions().stream()
                        .filter(transition -> transition.target().equals(state) && !transition.internal())
                        .findFirst()
                        .orElse(null);
    }

    private static Fate unknown(String model, String keyword, State state) {
        return new Fate.Stuck("the next " + model + " model has no state " + state + "; map it: " + keyword + " "
                + state + " -> STATE");
    }

    /**
     * @param device the device's state then, which distinguishes states that differ in their history; null if unknown
     */
    private @Nullable State same(
            State state, StateMachine old, StateMachine now, Map<State, State> mapped, @Nullable State device) {
        State plain = old.withoutMemory(state);
        State wanted = mapped.getOrDefault(state, mapped.get(plain));
        if (wanted == null && now.hasState(state)) {
            return state;
        }
        State named = wanted == null ? state : wanted;
        List<State> candidates = now.alike(named);
        if (candidates.isEmpty() && wanted == null) {
            candidates = now.alike(plain);
        }
        if (candidates.isEmpty() && wanted == null) {
            List<String> drawn = old.paths(state);
            candidates = now.states().stream()
                    .filter(other -> now.paths(other).equals(drawn))
                    .toList();
        }
        if (candidates.contains(named) && (device == null || isReachable(device, named))) {
            return named;
        }
        for (State candidate : candidates) {
            if (device != null && isReachable(device, candidate)) {
                return candidate;
            }
        }
        return candidates.isEmpty() ? null : candidates.get(0);
    }

    private boolean isReachable(State device, State system) {
        return next.configurations().contains(new Configuration(device, system));
    }
}
