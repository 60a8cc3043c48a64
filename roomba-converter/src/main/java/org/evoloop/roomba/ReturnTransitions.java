package org.evoloop.roomba;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.evoloop.evolution.ModelPair;
import org.evoloop.roomba.session.inference.ActivityEstimate.EstimatedActivity;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.statemachine.Transition;

/**
 * The transitions out of a Move that ends before arrival, which the model's author need not draw. They lead back to the
 * state in which the press that started Move occurred, or to the state that matches work started with the robot's own
 * buttons in the meantime. They are ordinary transitions of the new model, with events of their own.
 */
final class ReturnTransitions {
    static final String PREFIX = "backTo";

    private final ModelPair pair;
    private final StateMachine original;
    private final StateMachine evolved;
    private final Set<State> moves;

    ReturnTransitions(ModelPair pair, Set<State> moves) {
        this.pair = pair;
        this.original = pair.original();
        this.evolved = pair.evolved();
        this.moves = moves;
    }

    /** The event that leads back to a state: {@code backToOn}. */
    static String event(State state) {
        return PREFIX + state.name();
    }

    /** The new model with these transitions. */
    StateMachine drawn() {
        StateMachineBuilder builder =
                StateMachine.named(evolved.name()).initial(evolved.initial().name());
        for (State state : evolved.states()) {
            builder.drawn(
                    state,
                    evolved.withoutMemory(state),
                    evolved.activities(state),
                    evolved.paths(state),
                    evolved.isEnd(state));
            builder.device(state.name(), evolved, state);
            evolved.deferred(state).forEach(event -> builder.defers(state.name(), event));
        }
        evolved.events().forEach(builder::event);
        evolved.spontaneous().forEach(builder::spontaneous);
        evolved.urgent().forEach(builder::urgent);
        evolved.transitions().forEach(transition -> builder.transition(transition, ""));
        for (State move : moves) {
            Set<State> targets = new LinkedHashSet<>();
            for (Transition entry : entries(move)) {
                targets.add(before(entry));
            }
            for (EstimatedActivity activity : EstimatedActivity.values()) {
                if (activity != EstimatedActivity.STANDBY) {
                    RobotEvents.stateName(original, activity).map(State::new).ifPresent(targets::add);
                }
            }
            targets.removeIf(target -> moves.contains(target) || !canBeReached(target, move));
            for (State target : targets) {
                if (!evolved.hasTrigger(move, new Event(event(target)))) {
                    builder.transition(move.name(), event(target), target.name());
                }
            }
        }
        return builder.initialEffects(evolved.initialEffects()).build();
    }

    /** The transitions that lead into a state from another one. */
    List<Transition> entries(State state) {
        return evolved.transitions().stream()
                .filter(transition -> transition.target().equals(state)
                        && !transition.source().equals(state))
                .toList();
    }

    /** The state in which a press led, directly or indirectly, to this transition. */
    State before(Transition entry) {
        Set<State> seen = new LinkedHashSet<>();
        Deque<Transition> next = new ArrayDeque<>(List.of(entry));
        while (!next.isEmpty()) {
            Transition candidate = next.remove();
            State source = candidate.source();
            if (RobotEvents.isPress(candidate.event()) && !moves.contains(source)) {
                return source;
            }
            if (seen.add(source)) {
                next.addAll(entries(source));
            }
        }
        return entry.source();
    }

    /**
     * Whether, from each of its possible states when Move is entered, the device can be sent to the target or is there.
     */
    private boolean canBeReached(State target, State move) {
        if (!original.hasState(target)) {
            return evolved.hasState(target);
        }
        return deviceStates(move).stream().allMatch(from -> reachable(from).contains(target));
    }

    /**
     * The device's possible states in a new state: those in which it must be there, or else those from which the new
     * state is entered.
     */
    private Set<State> deviceStates(State state) {
        List<State> needed = pair.whereDeviceMustBe(state);
        if (!needed.isEmpty()) {
            return Set.copyOf(needed);
        }
        Set<State> found = new LinkedHashSet<>();
        Set<State> seen = new LinkedHashSet<>(Set.of(state));
        Deque<State> next = new ArrayDeque<>(seen);
        while (!next.isEmpty()) {
            for (Transition entry : entries(next.remove())) {
                State source = entry.source();
                List<State> there = pair.whereDeviceMustBe(source);
                if (!there.isEmpty()) {
                    found.addAll(there);
                } else if (seen.add(source)) {
                    next.add(source);
                }
            }
        }
        return found;
    }

    /** The states to which commands can take the device. */
    private Set<State> reachable(State from) {
        Set<State> seen = new LinkedHashSet<>(Set.of(from));
        Deque<State> next = new ArrayDeque<>(seen);
        while (!next.isEmpty()) {
            for (Transition transition : original.transitionsFrom(next.remove())) {
                Event event = transition.event();
                if (RobotEvents.COMMANDS.contains(event.name())
                        && event.guards().isEmpty()
                        && seen.add(transition.target())) {
                    next.add(transition.target());
                }
            }
        }
        return seen;
    }
}
