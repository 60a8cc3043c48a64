package org.evoloop.evolution;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
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
 * Chooses among transitions by their guards: of those of one state with the same trigger, the first as drawn whose
 * guards all hold.
 *
 * <p>Threading: immutable. Nothing is allocated for states and triggers without guards.
 *
 * @since 0.1
 */
public final class GuardedTriggers {
    /**
     * Only triggers with a guard on some transition of the state; the transitions in the order in which they are tried.
     */
    private final Map<State, Map<Event, List<Transition>>> guarded = new HashMap<>();

    /** Finds the guarded triggers of this machine. */
    public GuardedTriggers(StateMachine machine) {
        if (machine.guards().isEmpty()) {
            return;
        }
        for (State state : machine.states()) {
            Map<Event, List<Transition>> byTrigger = new HashMap<>();
            for (Transition transition : machine.transitionsFrom(state)) {
                if (!transition.event().guards().isEmpty()) {
                    byTrigger.put(transition.event().trigger(), new ArrayList<>());
                }
            }
            for (Transition transition : machine.transitionsFrom(state)) {
                List<Transition> candidates = byTrigger.get(transition.event().trigger());
                if (candidates != null) {
                    candidates.add(transition);
                }
            }
            if (!byTrigger.isEmpty()) {
                guarded.put(state, byTrigger);
            }
        }
    }

    /**
     * {@code trigger} with the guards of the transition that it takes in {@code state} now.
     *
     * @param holds whether the condition of this text holds
     * @return {@code trigger} itself where no guard is drawn for it; null if guards are drawn and none holds
     */
    public @Nullable Event resolve(State state, Event trigger, Predicate<String> holds) {
        Map<Event, List<Transition>> byTrigger = guarded.get(state);
        List<Transition> candidates = byTrigger == null ? null : byTrigger.get(trigger);
        if (candidates == null) {
            return trigger;
        }
        for (Transition candidate : candidates) {
            if (candidate.event().guards().stream().allMatch(holds)) {
                return candidate.event();
            }
        }
        return null;
    }

    /** Whether guards decide which transition {@code trigger} takes in {@code state}. */
    boolean decideOn(State state, Event trigger) {
        Map<Event, List<Transition>> byTrigger = guarded.get(state);
        return byTrigger != null && byTrigger.containsKey(trigger);
    }

    /**
     * The guards that decide whether {@code transition} is taken: its own, and those of the transitions tried before
     * it.
     */
    Set<String> conditionsOf(Transition transition) {
        List<Transition> candidates = candidatesWith(transition);
        if (candidates.isEmpty()) {
            return Set.of();
        }
        Set<String> conditions = new LinkedHashSet<>();
        for (Transition tried : candidates) {
            conditions.addAll(tried.event().guards());
            if (tried.equals(transition)) {
                break;
            }
        }
        return conditions;
    }

    /**
     * A transition that is tried before {@code transition} and is always taken in its place; null if there is none, so
     * that {@code transition} can be taken.
     */
    public @Nullable Transition shadowOf(Transition transition) {
        List<Transition> candidates = candidatesWith(transition);
        if (candidates.isEmpty()) {
            return null;
        }
        Set<String> own = new HashSet<>(transition.event().guards());
        for (Transition tried : candidates) {
            if (tried.equals(transition)) {
                return null;
            }
            if (own.containsAll(tried.event().guards())) {
                return tried;
            }
        }
        return null;
    }

    private List<Transition> candidatesWith(Transition transition) {
        Map<Event, List<Transition>> byTrigger = guarded.isEmpty() ? null : guarded.get(transition.source());
        return byTrigger == null
                ? List.of()
                : byTrigger.getOrDefault(transition.event().trigger(), List.of());
    }
}
