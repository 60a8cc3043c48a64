package org.evoloop.check;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Turn;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/**
 * What functions of new states may have the device do: what the new model declares, at any time and any number of times.
 * A converter refuses anything else.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class FunctionSends {
    /** What the author of a property can do about it. */
    public static final String REMEDY =
            "ask for less where such a function runs, or let the model have it done: draw a "
                    + "new state that needs the device there («device STATE»)";

    private static final int LISTED = 5;

    private final CheckInput input;
    private final Set<State> states;

    private FunctionSends(CheckInput input, Set<State> states) {
        this.input = input;
        this.states = states;
    }

    /** By every new state that declares what its function sends. */
    public static FunctionSends possible(CheckInput input) {
        Set<State> states = new LinkedHashSet<>(input.pair().evolved().states());
        states.removeIf(state -> !input.pair().isNew(state)
                || input.pair().evolved().sends(state).isEmpty());
        return new FunctionSends(input, states);
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
    public List<Turn> from(Configuration at, DecisionTable table) {
        List<Turn> sends = new ArrayList<>();
        if (states.contains(at.evolved())) {
            StateMachine original = input.pair().original();
            for (Transition transition : original.transitionsFrom(at.original())) {
                Event event = transition.event();
                Decision asked = table.ask(at, event.trigger(), event.guards()::contains);
                if (asked instanceof Decision.Sending
                        && asked.steps().get(0).transition().equals(transition)) {
                    sends.add(new Turn(event, false, asked));
                }
            }
        }
        return sends;
    }
}
