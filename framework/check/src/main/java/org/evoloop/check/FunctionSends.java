package org.evoloop.check;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Turn;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/**
 * What functions of new states may have the device do. Nothing declares what they send, so each of them may send
 * whatever can be sent, at any time and any number of times.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class FunctionSends {
    /** What the author of a property can do about it. */
    public static final String REMEDY = "ask for less where such a function runs, or list the new states that have a "
            + "function with --functions";

    private static final int LISTED = 5;

    private final CheckInput input;
    private final Set<State> states;

    private FunctionSends(CheckInput input, Set<State> states) {
        this.input = input;
        this.states = states;
    }

    /** By every new state that has a function; where it is unknown which have one, by every new state. */
    public static FunctionSends possible(CheckInput input) {
        Set<State> states = new LinkedHashSet<>(input.pair().evolved().states());
        states.removeIf(state -> !input.pair().isNew(state) || !mayHaveFunction(input, state));
        return new FunctionSends(input, states);
    }

    private static boolean mayHaveFunction(CheckInput input, State state) {
        Set<String> functions = input.functions();
        return functions == null
                || functions.contains(state.name())
                || functions.contains(
                        input.pair().evolved().withoutMemory(state).name());
    }

    /** The states whose functions may send. */
    public Set<State> states() {
        return new LinkedHashSet<>(states);
    }

    /** Whether there is nothing that could be sent. */
    public boolean isEmpty() {
        return states.isEmpty() || input.device().sendable().isEmpty();
    }

    /** For messages: {@code the function of Move may send events to the device}. */
    public String describe() {
        String names = states.stream().limit(LISTED).map(State::name).collect(Collectors.joining(", "));
        return (states.size() == 1 ? "the function of " : "the functions of ") + names
                + (states.size() > LISTED ? " and " + (states.size() - LISTED) + " more" : "")
                + " may send events to the device";
    }

    /** Only by the functions of these states. */
    public FunctionSends only(Collection<State> some) {
        return new FunctionSends(input, new LinkedHashSet<>(some));
    }

    /** What the function that runs in {@code at} may send: a {@link Decision.Sending} each. */
    public List<Turn> from(Configuration at) {
        List<Turn> sends = new ArrayList<>();
        if (states.contains(at.evolved())) {
            StateMachine original = input.pair().original();
            for (Transition transition : original.transitionsFrom(at.original())) {
                Event trigger = transition.event().trigger();
                if (input.device().sendable().contains(trigger)) {
                    boolean conditional = !transition.event().guards().isEmpty();
                    Step step = new Step(transition, trigger, false, conditional);
                    Configuration after = at.withOriginal(transition.target());
                    sends.add(new Turn(transition.event(), false, new Decision.Sending(at, after, List.of(step))));
                }
            }
        }
        return sends;
    }
}
