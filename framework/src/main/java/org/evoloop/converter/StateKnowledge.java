package org.evoloop.converter;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.ModelPair;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.Knowledge;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * What a converter knows: both models, their current states, and the functions of new states (paper, section V.B).
 * Extend it and register the functions in {@link #registerNewFunctions}.
 *
 * <p>Threading: the methods that register are for {@link #registerNewFunctions} and before; the rest is thread-safe.
 */
public class StateKnowledge extends Knowledge {
    private final ModelPair pair;
    private final Map<State, NewFunction> functions = new HashMap<>();
    private final Map<State, Map<Event, Duration>> timers = new HashMap<>();
    private final Map<Transition, NewFunction> actions = new HashMap<>();
    private volatile Configuration current;
    private volatile @Nullable DecisionTable table;

    /** @throws org.evoloop.statemachine.ModelException if the pair violates Condition 1 or 2 */
    public StateKnowledge(ModelPair pair) {
        pair.requireValid();
        this.pair = pair;
        this.current = pair.initial();
    }

    /** Registers the functions and timers of new states; called once, when the converter is built. */
    protected void registerNewFunctions() {}

    /** Runs {@code function} whenever the new state {@code state} is entered. */
    protected final void function(String state, NewFunction function) {
        functions.put(new State(state), function);
    }

    /**
     * Raises {@code event} when {@code state} has lasted for {@code delay}. Time triggers written in the model, such as
     * {@code tm(2s)}, need no call.
     */
    protected final void timer(String state, String event, Duration delay) {
        timers.computeIfAbsent(new State(state), key -> new LinkedHashMap<>()).put(new Event(event), delay);
    }

    /**
     * Registers what runs when one transition of the new model is taken, in place of the function of its target.
     *
     * @param source the current state (the paper's s0)
     * @param target the next state (s1), a new one
     * @param action the function to be called
     * @param event the incoming event
     */
    public final void putTransition(String source, String target, NewFunction action, String event) {
        actions.put(new Transition(new State(source), new Event(event), new State(target)), action);
    }

    /** The transition of the new model that {@code event} triggers in {@code source}, with its function. */
    public final Optional<BoundTransition> getTransition(State source, Event event) {
        return pair.evolved()
                .transition(source, event)
                .map(transition -> new BoundTransition(source, event, transition.target(), action(transition)));
    }

    private NewFunction action(Transition transition) {
        NewFunction action = actions.get(transition);
        return action != null ? action : functionOf(transition.target());
    }

    final NewFunction functionOf(State state) {
        return functions.getOrDefault(state, NewFunction.none());
    }

    /** Every event that is raised by itself in {@code state}, and after how long. */
    final Map<Event, Duration> timersOf(State state) {
        Map<Event, Duration> all = new LinkedHashMap<>(timers.getOrDefault(state, Map.of()));
        for (Transition transition : pair.evolved().transitionsFrom(state)) {
            transition.event().timeTrigger().ifPresent(delay -> all.put(transition.event(), delay));
        }
        return all;
    }

    /** Both models. */
    public final ModelPair models() {
        return pair;
    }

    /** The current state of the new model. */
    public final State getCurrentState() {
        return current.evolved();
    }

    /** The current state of the original model: where the device is. */
    public final State getOriginalState() {
        return current.original();
    }

    /** The current states of both models, as of one moment. */
    public final Configuration configuration() {
        return current;
    }

    final void move(Configuration next) {
        current = next;
    }

    /** The transition hash table: what an event means in each configuration. Compiled when the converter is built. */
    final DecisionTable table() {
        DecisionTable compiled = table;
        if (compiled == null) {
            throw new IllegalStateException(name() + " is not part of a converter that was built");
        }
        return compiled;
    }

    final void use(DecisionTable next) {
        table = next;
    }

    /** What is wrong with what was registered, a line each. */
    final List<String> problems() {
        List<String> problems = new ArrayList<>();
        for (State state : functions.keySet()) {
            if (!pair.evolved().hasState(state)) {
                problems.add("a function is registered for " + state + ", which is not a state of the new model");
            } else if (!pair.isNew(state)) {
                problems.add("a function is registered for " + state + ", but the device itself has that state");
            }
        }
        timers.forEach((state, byEvent) -> byEvent.forEach((event, delay) -> {
            if (!pair.evolved().hasTransition(state, event)) {
                problems.add(
                        "a timer raises " + event + " in " + state + ", where the new model has no transition for it");
            }
            if (delay.isNegative()) {
                problems.add("the timer that raises " + event + " in " + state + " has the negative delay " + delay);
            }
        }));
        for (Transition transition : actions.keySet()) {
            if (!pair.evolved().transitions().contains(transition)) {
                problems.add("an action is registered for " + transition + ", which the new model does not have");
            } else if (!pair.isNew(transition.target())) {
                problems.add("an action is registered for " + transition + ", but its target is a state of the device");
            }
        }
        for (State state : pair.evolved().states()) {
            if (pair.isNew(state) && !isCovered(state)) {
                problems.add("new state " + state + " has no function: register one in registerNewFunctions, "
                        + "NewFunction.none() if nothing has to run");
            }
        }
        return problems;
    }

    private boolean isCovered(State state) {
        List<Transition> entries = pair.evolved().transitions().stream()
                .filter(transition -> transition.target().equals(state))
                .toList();
        return functions.containsKey(state)
                || !timersOf(state).isEmpty()
                || (!entries.isEmpty() && actions.keySet().containsAll(entries));
    }
}
