package org.evoloop.migration;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;

/**
 * What the author of a swap says of states, timers and functions that do not go by their names. All that it does not name
 * goes by name.
 *
 * <p>Threading: immutable.
 *
 * @param device what states of the running original model become
 * @param states what states of the running new model become
 * @param timers what timers become
 * @param restartedTimers timers that begin anew instead of going on
 * @param restartedFunctions states whose function begins anew, though it could go on
 * @param keptFunctions states whose function goes on, though the next state's has another name
 * @since 0.1
 */
public record Mapping(
        Map<State, State> device,
        Map<State, State> states,
        Map<TimerOf, String> timers,
        Set<TimerOf> restartedTimers,
        Set<State> restartedFunctions,
        Set<State> keptFunctions) {
    public Mapping {
        device = Map.copyOf(device);
        states = Map.copyOf(states);
        timers = Map.copyOf(timers);
        restartedTimers = Set.copyOf(restartedTimers);
        restartedFunctions = Set.copyOf(restartedFunctions);
        keptFunctions = Set.copyOf(keptFunctions);
    }

    /** A timer of a state of the running new model, by the name of its event. */
    public record TimerOf(State state, String timer) {}

    /** Everything goes by name. */
    public static Mapping byName() {
        return new Mapping(Map.of(), Map.of(), Map.of(), Set.of(), Set.of(), Set.of());
    }

    /**
     * Reads a mapping, a rule a line: {@code state A -> B} and {@code device A -> B} for a state of the new and of the original
     * model, {@code timer T of A -> T2}, {@code timer T of A restarts}, {@code function of A restarts}, {@code function of A
     * goes on}. Empty lines, and those that begin with {@code #}, count for nothing.
     *
     * @param file for messages
     * @throws ModelException naming file, line and mend of all that cannot be understood or that the models lack
     */
    public static Mapping parse(String file, String text, ModelPair running, ModelPair next) {
        return MappingText.parse(file, text, running, next);
    }

    /**
     * What leads back. Of several states that become one, the first by name is what that one becomes again.
     */
    public Mapping reversed() {
        Map<State, State> back = reversed(states);
        UnaryOperator<State> there = state -> states.getOrDefault(state, state);
        Map<TimerOf, String> timersBack = new HashMap<>();
        timers.forEach((timer, name) -> timersBack.put(new TimerOf(there.apply(timer.state()), name), timer.timer()));
        Set<TimerOf> restarted = restartedTimers.stream()
                .map(timer -> new TimerOf(there.apply(timer.state()), timer.timer()))
                .collect(Collectors.toSet());
        return new Mapping(
                reversed(device),
                back,
                timersBack,
                restarted,
                restartedFunctions.stream().map(there).collect(Collectors.toSet()),
                keptFunctions.stream().map(there).collect(Collectors.toSet()));
    }

    private static Map<State, State> reversed(Map<State, State> there) {
        Map<State, State> back = new HashMap<>();
        new TreeMap<>(there).forEach((from, to) -> back.putIfAbsent(to, from));
        return back;
    }

    /** The same with {@code next} in place of {@code state} of the running new model. */
    public Mapping withState(State state, State next) {
        Map<State, State> all = new HashMap<>(states);
        all.put(state, next);
        return new Mapping(device, all, timers, restartedTimers, restartedFunctions, keptFunctions);
    }

    /** The same with {@code next} in place of {@code state} of the running original model. */
    public Mapping withDeviceState(State state, State next) {
        Map<State, State> all = new HashMap<>(device);
        all.put(state, next);
        return new Mapping(all, states, timers, restartedTimers, restartedFunctions, keptFunctions);
    }

    /** The same where {@code timer} goes on as the timer {@code next} of the next state. */
    public Mapping withTimer(TimerOf timer, String next) {
        Map<TimerOf, String> all = new HashMap<>(timers);
        all.put(timer, next);
        return new Mapping(device, states, all, restartedTimers, restartedFunctions, keptFunctions);
    }

    /** The same where {@code timer} begins anew. */
    public Mapping withRestarted(TimerOf timer) {
        Set<TimerOf> all = new HashSet<>(restartedTimers);
        all.add(timer);
        return new Mapping(device, states, timers, all, restartedFunctions, keptFunctions);
    }

    /** The same where the function of {@code state} goes on, whatever its name, or else begins anew. */
    public Mapping withFunction(State state, boolean goesOn) {
        Set<State> kept = new HashSet<>(keptFunctions);
        Set<State> restarted = new HashSet<>(restartedFunctions);
        (goesOn ? kept : restarted).add(state);
        return new Mapping(device, states, timers, restartedTimers, restarted, kept);
    }
}
