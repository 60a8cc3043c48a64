package org.evoloop.migration;

import static java.util.Objects.requireNonNull;

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
 * The exceptions, given by the author of a swap, for states, timers and functions that are not mapped by name.
 * Everything else is mapped by name.
 *
 * <p>No argument may be null; a {@link NullPointerException} says which one is.
 *
 * <p>Threading: immutable.
 *
 * @param device states of the running original model, with their successors
 * @param states states of the running new model, with their successors
 * @param timers timers, with their successors
 * @param restartedTimers timers that start again instead of continuing
 * @param restartedFunctions states whose function starts again, though it could continue
 * @param keptFunctions states whose function continues, though the next state's has another name
 * @since 0.1
 */
public record Mapping(
        Map<State, State> device,
        Map<State, State> states,
        Map<TimerOf, String> timers,
        Set<TimerOf> restartedTimers,
        Set<State> restartedFunctions,
        Set<State> keptFunctions) {
    private static final String NO_STATE = "the state to be mapped is null";
    private static final String NO_SUCCESSOR = "the successor of a state is null";
    private static final String NO_TIMER = "the timer to be mapped is null";

    public Mapping {
        device = Map.copyOf(requireNonNull(device, "the successors of the device's states are null"));
        states = Map.copyOf(requireNonNull(states, "the successors of states are null"));
        timers = Map.copyOf(requireNonNull(timers, "the successors of timers are null"));
        restartedTimers = Set.copyOf(requireNonNull(restartedTimers, "the timers that restart are null"));
        restartedFunctions = Set.copyOf(requireNonNull(restartedFunctions, "the functions that restart are null"));
        keptFunctions = Set.copyOf(requireNonNull(keptFunctions, "the functions that go on are null"));
    }

    /** A timer of a state of the running new model, by the name of its event. */
    public record TimerOf(State state, String timer) {
        /** Nothing may be null. */
        public TimerOf {
            requireNonNull(state, "the state of a timer is null");
            requireNonNull(timer, "the name of a timer is null");
        }
    }

    /** Maps everything by name. */
    public static Mapping byName() {
        return new Mapping(Map.of(), Map.of(), Map.of(), Set.of(), Set.of(), Set.of());
    }

    /**
     * Reads a mapping, one rule per line: {@code state A -> B} and {@code device A -> B} for a state of the new and of
     * the original model, {@code timer T of A -> T2}, {@code timer T of A restarts}, {@code function of A restarts},
     * {@code function of A goes on}. Empty lines and lines that begin with {@code #} are ignored.
     *
     * @param file for messages
     * @throws ModelException if a line cannot be understood or names something that the models lack; the message gives
     *     the file and, for each problem, the line and the remedy
     */
    public static Mapping parse(String file, String text, ModelPair running, ModelPair next) {
        return MappingText.parse(file, text, running, next);
    }

    /**
     * The mapping back. Where several states have one successor, that is mapped back to the first of them by name.
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

    /** A copy in which {@code state} of the running new model becomes {@code next}. */
    public Mapping withState(State state, State next) {
        Map<State, State> all = new HashMap<>(states);
        all.put(requireNonNull(state, NO_STATE), requireNonNull(next, NO_SUCCESSOR));
        return new Mapping(device, all, timers, restartedTimers, restartedFunctions, keptFunctions);
    }

    /** A copy in which {@code state} of the running original model becomes {@code next}. */
    public Mapping withDeviceState(State state, State next) {
        Map<State, State> all = new HashMap<>(device);
        all.put(requireNonNull(state, NO_STATE), requireNonNull(next, NO_SUCCESSOR));
        return new Mapping(all, states, timers, restartedTimers, restartedFunctions, keptFunctions);
    }

    /** A copy in which {@code timer} continues as the timer {@code next} of the next state. */
    public Mapping withTimer(TimerOf timer, String next) {
        Map<TimerOf, String> all = new HashMap<>(timers);
        all.put(requireNonNull(timer, NO_TIMER), requireNonNull(next, "the successor of a timer is null"));
        return new Mapping(device, states, all, restartedTimers, restartedFunctions, keptFunctions);
    }

    /** A copy in which {@code timer} starts again. */
    public Mapping withRestarted(TimerOf timer) {
        Set<TimerOf> all = new HashSet<>(restartedTimers);
        all.add(requireNonNull(timer, NO_TIMER));
        return new Mapping(device, states, timers, all, restartedFunctions, keptFunctions);
    }

    /** A copy in which the function of {@code state} continues, whatever its name, or else starts again. */
    public Mapping withFunction(State state, boolean continues) {
        Set<State> kept = new HashSet<>(keptFunctions);
        Set<State> restarted = new HashSet<>(restartedFunctions);
        (continues ? kept : restarted).add(requireNonNull(state, NO_STATE));
        return new Mapping(device, states, timers, restartedTimers, restarted, kept);
    }
}
