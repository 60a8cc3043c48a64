package org.evoloop.roomba;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.evoloop.evolution.ModelPair;
import org.evoloop.roomba.session.inference.ActivityEstimate.EstimatedActivity;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;

/**
 * The robot's models, and the assignment of this program's functions to their new states.
 *
 * <p>Threading: immutable.
 */
public final class RobotModels {
    private final ModelPair pair;
    private final Map<State, RobotFunction> functions;
    private final Set<State> moves;
    private final ReturnTransitions waysBack;

    private RobotModels(ModelPair drawn, Map<State, RobotFunction> functions) {
        this.functions = functions;
        this.moves = new LinkedHashSet<>(functions.keySet());
        moves.removeIf(state -> functions.get(state) != RobotFunction.MOVE);
        this.waysBack = new ReturnTransitions(drawn, moves);
        this.pair = moves.isEmpty() ? drawn : new ModelPair(drawn.original(), waysBack.drawn());
    }

    /**
     * Assigns functions by the new states' do activities. Without those, Move and SpotWait run in the only new state
     * that is left by the event they finish with, {@code arriveSpot} and {@code timeout}.
     *
     * @throws ModelException if the models are not an evolution, or a new state has no function
     */
    public static RobotModels of(ModelPair drawn) {
        return of(drawn, List.of());
    }

    /**
     * As {@link #of(ModelPair)}, except for explicitly assigned states.
     *
     * @param wanted each {@code STATE=FUNCTION}
     * @throws ModelException as above
     */
    static RobotModels of(ModelPair drawn, List<String> wanted) {
        drawn.requireValid();
        return new RobotModels(drawn, FunctionBinding.bind(drawn, wanted));
    }

    /** The models, with transitions added for the ways out of Move that are not drawn. */
    ModelPair pair() {
        return pair;
    }

    Map<State, RobotFunction> functions() {
        return functions;
    }

    /** The states in which Move runs. */
    Set<State> moves() {
        return moves;
    }

    /** Whether SpotWait raises {@code timeout} in a state that no time trigger of the model leaves. */
    boolean hasSpotWait() {
        return functions.entrySet().stream()
                .anyMatch(entry -> entry.getValue() == RobotFunction.SPOT_WAIT
                        && RobotFunction.SPOT_WAIT.finishesIn(pair.evolved(), entry.getKey()));
    }

    /**
     * The events of an external controller: first those of the robot's own buttons, then those only in the new model.
     */
    List<String> buttons() {
        Set<String> known = new LinkedHashSet<>();
        pair.evolved().triggers().stream()
                .filter(RobotEvents::isPress)
                .map(Event::name)
                .filter(name -> !name.startsWith(ReturnTransitions.PREFIX))
                .forEach(known::add);
        List<String> buttons = new ArrayList<>(RobotEvents.COMMANDS);
        buttons.retainAll(known);
        known.removeAll(buttons);
        buttons.addAll(known);
        return buttons;
    }

    /** The transitions that lead into a state of Move from another one. */
    List<Transition> entries(State move) {
        return waysBack.entries(move);
    }

    /** The state to which a Move entered by this transition returns if it does not arrive. */
    State before(Transition entry) {
        return waysBack.before(entry);
    }

    /**
     * The event that leads back out of a Move that has not arrived.
     *
     * @param work what the robot does by itself; empty if it is at rest
     * @param before the state before Move
     */
    String wayBack(Optional<EstimatedActivity> work, State before) {
        State target = work.flatMap(activity -> RobotEvents.stateName(pair.original(), activity))
                .map(State::new)
                .orElse(before);
        String event = ReturnTransitions.event(target);
        // If the robot was woken or undocked for Move, it does not return to that state.
        return pair.evolved().triggers().contains(new Event(event))
                ? event
                : ReturnTransitions.event(new State(RobotEvents.STATE_ON));
    }

    /** Whether an event leads from a state of Move to a state of Move. */
    boolean restartsMove(State now, String event) {
        return moves.contains(now)
                && pair.evolved().transitionsFrom(now).stream()
                        .anyMatch(transition -> transition.event().name().equals(event)
                                && !transition.internal()
                                && moves.contains(transition.target()));
    }
}
